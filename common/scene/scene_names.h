#pragma once

#include <span>
#include <string>
#include <string_view>

namespace hipmap {

/// `name` as one line of valid UTF-8: control characters become spaces, broken bytes '?'.
std::string clean_name(std::string_view name);

/// `name` in quotes, cut to a length that fits a message.
std::string quote_name(std::string_view name);

/// "'a', 'b', 'c' and 4 more": each name once, in the order given.  Empty: "".
std::string list_names(std::span<const std::string> names);

/// `count` with the noun, as "1 face" or "12,345 faces"; `plural` empty: noun + "s".
std::string counted(std::size_t count, std::string_view noun, std::string_view plural = {});

/// A number as short as it can be read: 3 significant digits.
std::string short_number(double value);

} // namespace hipmap
