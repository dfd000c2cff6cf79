#pragma once

#include <cstdint>
#include <string>
#include <variant>

namespace hipmap {

/// The value of a setting.  monostate: not given.  A choice is its name.
using SettingValue = std::variant<std::monostate, bool, std::uint64_t, double, std::string>;

/// A setting and its name, as on the command line without the dashes.
struct Setting {
    std::string name;
    SettingValue value;
    bool operator==(const Setting&) const = default;
};

/// Formats a value for people: "none", "on", "off", "200000", "0.5", "progressive".  A number is
/// the shortest text that names no other number.
std::string text_of(const SettingValue& value);

/// Formats a setting as "name=value".
std::string text_of(const Setting& setting);

} // namespace hipmap
