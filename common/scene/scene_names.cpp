#include "common/scene/scene_names.h"

#include "common/report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace hipmap {

namespace {

constexpr std::size_t kLongestName = 60;
constexpr std::size_t kNamesListed = 5;

bool is_continuation(unsigned char byte)
{
    return (byte & 0xc0u) == 0x80u;
}

/// Length of the well-formed UTF-8 sequence at the start of `text`; 0 if there is none
/// (Unicode 15, table 3-7).
std::size_t utf8_length(std::string_view text)
{
    const auto byte = [&](std::size_t i) {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : 0;
    };
    const unsigned lead = byte(0), second = byte(1);
    if (lead < 0x80)
        return 1;
    if (lead < 0xc2 || lead > 0xf4 || !is_continuation(byte(1)))
        return 0;
    if (lead < 0xe0)
        return 2;
    if (!is_continuation(byte(2)) || (lead == 0xe0 && second < 0xa0) ||
        (lead == 0xed && second > 0x9f))
        return 0;
    if (lead < 0xf0)
        return 3;
    if (!is_continuation(byte(3)) || (lead == 0xf0 && second < 0x90) ||
        (lead == 0xf4 && second > 0x8f))
        return 0;
    return 4;
}

} // namespace

std::string clean_name(std::string_view name)
{
    std::string clean;
    clean.reserve(name.size());
    while (!name.empty()) {
        const std::size_t length = utf8_length(name);
        const auto first = static_cast<unsigned char>(name[0]);
        if (length == 0)
            clean += '?';
        else if (first < 0x20 || first == 0x7f)
            clean += ' ';
        else
            clean.append(name.substr(0, length));
        name.remove_prefix(std::max<std::size_t>(1, length));
    }
    return clean;
}

std::string quote_name(std::string_view name)
{
    std::string text = clean_name(name);
    if (text.size() > kLongestName) {
        std::size_t end = kLongestName;
        while (end > 0 && is_continuation(static_cast<unsigned char>(text[end])))
            --end;
        text.resize(end);
        text.append("...");
    }
    return std::string("'").append(text).append("'");
}

std::string list_names(std::span<const std::string> names)
{
    std::vector<std::string> unique;
    std::size_t more = 0;
    std::vector<std::string> seen(names.begin(), names.end());
    std::sort(seen.begin(), seen.end());
    const auto distinct =
        static_cast<std::size_t>(std::unique(seen.begin(), seen.end()) - seen.begin());
    for (const std::string& name : names)
        if (unique.size() < kNamesListed &&
            std::find(unique.begin(), unique.end(), name) == unique.end())
            unique.push_back(name);
    more = distinct - unique.size();

    std::string list;
    for (std::size_t i = 0; i < unique.size(); ++i) {
        if (i > 0)
            list += more == 0 && i + 1 == unique.size() ? " and " : ", ";
        list += quote_name(unique[i]);
    }
    if (more > 0)
        list.append(" and ").append(std::to_string(more)).append(" more");
    return list;
}

std::string counted(std::size_t count, std::string_view noun, std::string_view plural)
{
    std::string text = grouped(count) + ' ';
    if (count == 1)
        return text.append(noun);
    return plural.empty() ? text.append(noun).append("s") : text.append(plural);
}

std::string short_number(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    double rounded = 0;
    std::sscanf(text, "%lf", &rounded);
    constexpr double kLeast = 1000, kMost = 1e18; // without an exponent between them
    if (!(std::abs(rounded) >= kLeast && std::abs(rounded) < kMost))
        return text;
    return std::string(rounded < 0 ? "-" : "")
        .append(grouped(static_cast<std::uint64_t>(std::abs(rounded))));
}

} // namespace hipmap
