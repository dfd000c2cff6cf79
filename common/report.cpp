#include "common/report.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <string>
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

std::string progress_text(std::string_view stage, std::optional<double> done, std::string_view note,
                          double elapsed)
{
    std::vector<std::string> parts;
    const double share = done && *done > 0 ? std::min(*done, 1.0) : 0.0;
    if (done)
        parts.push_back(std::to_string(static_cast<int>(share * 100)) + " %");
    if (!note.empty())
        parts.emplace_back(note);
    if (share > 0)
        parts.push_back(format_seconds(elapsed * (1 - share) / share) + " left");
    std::string text(stage);
    for (std::size_t i = 0; i < parts.size(); ++i)
        text += (i == 0 ? ": " : ", ") + parts[i];
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

void Report::progress(std::optional<double> done, std::string_view note)
{
    const std::lock_guard lock(mutex_);
    const auto now = Clock::now();
    if (seconds_between(shown_, now) < (on_terminal() ? kTerminalInterval : kPlainInterval))
        return;
    shown_ = now;
    const std::string text = progress_text(stage_, done, note, seconds_between(begun_, now));
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

} // namespace hipmap
