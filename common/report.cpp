#include "common/report.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace hipmap {

namespace {

constexpr double kTerminalInterval = 0.1; // s between two rewrites of the progress line
constexpr double kPlainInterval = 5.0;    // s between two plain lines
constexpr std::string_view kEraseLine = "\r\x1b[K";

bool on_terminal()
{
    static const bool terminal = isatty(STDERR_FILENO) == 1;
    return terminal;
}

double seconds_between(std::chrono::steady_clock::time_point from,
                       std::chrono::steady_clock::time_point to)
{
    return std::chrono::duration<double>(to - from).count();
}

} // namespace

std::string format_seconds(double seconds)
{
    char text[64];
    if (seconds < 100) {
        std::snprintf(text, sizeof text, "%.2f s", seconds);
    } else {
        const auto whole = std::llround(seconds);
        std::snprintf(text, sizeof text, "%lld:%02lld:%02lld", whole / 3600, whole / 60 % 60,
                      whole % 60);
    }
    return text;
}

std::string brief_time(double seconds)
{
    constexpr double kHour = 3600, kDay = 24 * kHour;
    char text[64];
    if (seconds < 9.95)
        std::snprintf(text, sizeof text, "%.2g s", seconds);
    else if (seconds < 99.5)
        std::snprintf(text, sizeof text, "%.0f s", seconds);
    else if (seconds < 99.5 * 60)
        std::snprintf(text, sizeof text, "%.0f min", seconds / 60);
    else if (seconds < 2 * kDay)
        std::snprintf(text, sizeof text, "%.*f h", seconds < 10 * kHour ? 1 : 0, seconds / kHour);
    else
        std::snprintf(text, sizeof text, "%.0f days", seconds / kDay);
    return text;
}

std::string grouped(std::uint64_t number)
{
    const std::string digits = std::to_string(number);
    std::string text;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (i > 0 && (digits.size() - i) % 3 == 0)
            text += ',';
        text += digits[i];
    }
    return text;
}

std::string progress_text(std::string_view stage, std::optional<double> done, std::string_view note,
                          std::optional<double> left)
{
    std::vector<std::string> parts;
    const double share = done && *done > 0 ? std::min(*done, 1.0) : 0.0;
    if (done)
        parts.push_back(std::to_string(static_cast<int>(share * 100)) + " %");
    if (!note.empty())
        parts.emplace_back(note);
    if (left)
        parts.push_back(brief_time(*left) + " left");
    std::string text(stage);
    for (std::size_t i = 0; i < parts.size(); ++i)
        text.append(i == 0 ? ": " : ", ").append(parts[i]);
    return text;
}

void Report::line(std::string_view text)
{
    const std::lock_guard lock(mutex_);
    if (line_open_)
        std::cerr << kEraseLine;
    line_open_ = false;
    std::cerr << text << '\n' << std::flush;
}

void Report::detail(std::string_view text)
{
    if (verbose_)
        line(text);
}

void Report::wrote(const std::filesystem::path& file, const std::string& note)
{
    const std::lock_guard lock(mutex_);
    files_.append(files_.empty() ? "" : ", ").append(file.string());
    if (!note.empty())
        files_.append(" (").append(note).append(")");
}

std::string Report::take_files()
{
    const std::lock_guard lock(mutex_);
    return std::exchange(files_, {});
}

void Report::list_files()
{
    if (const std::string files = take_files(); !files.empty())
        line("wrote " + files);
}

void Report::warn(std::string_view text)
{
    line("warning: " + std::string(text));
    const std::lock_guard lock(mutex_);
    ++warnings_;
}

void Report::begin(std::string_view stage)
{
    const std::lock_guard lock(mutex_);
    stage_ = stage;
    begun_ = shown_ = Clock::now();
}

void Report::progress(std::optional<double> done, std::string_view note, std::optional<double> left)
{
    const std::lock_guard lock(mutex_);
    const auto now = Clock::now();
    if (seconds_between(shown_, now) < (on_terminal() ? kTerminalInterval : kPlainInterval))
        return;
    shown_ = now;
    if (!left && done && *done > 0)
        left = seconds_between(begun_, now) * std::max(1 / *done - 1, 0.0);
    const std::string text = progress_text(stage_, done, note, left);
    if (on_terminal())
        std::cerr << kEraseLine << text << std::flush;
    else
        std::cerr << text << '\n' << std::flush;
    line_open_ = on_terminal();
}

double Report::end()
{
    const double seconds = seconds_between(begun_, Clock::now());
    line(stage_ + ": " + format_seconds(seconds));
    return seconds;
}

void Report::end_quietly()
{
    detail(stage_ + ": " + format_seconds(seconds_between(begun_, Clock::now())));
}

} // namespace hipmap
