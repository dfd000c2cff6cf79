#pragma once

#include <span>
#include <string>
#include <string_view>

namespace hipmap {

/// Returns `name` as one line of valid UTF-8: control characters become spaces, broken bytes '?'.
std::string clean_name(std::string_view name);

/// Returns `name` in quotes, cut to a length that fits a message.
std::string quote_name(std::string_view name);

/// Lists names as "'a', 'b', 'c' and 4 more": each name once, in the order given.  Empty: "".
std::string list_names(std::span<const std::string> names);

/// Returns `count` with the noun, such as "1 face" or "12,345 faces"; `plural` empty: noun + "s".
std::string counted(std::size_t count, std::string_view noun, std::string_view plural = {});

/// Formats a number with 3 significant digits and without an exponent up to 1e18.
std::string short_number(double value);

} // namespace hipmap
