#pragma once

#include "common/command_line/choice.h"
#include "common/command_line/picture_size.h"
#include "common/setting.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace CLI { // CLI11 takes long to compile, so only sources include it
class App;
class Option;
} // namespace CLI

namespace hipmap {

/// Converts between the text after an option and the value of a field.  The field must outlive the
/// OptionField.
struct OptionField {
    /// Adds the option to a command line.
    std::function<CLI::Option*(CLI::App&, const std::string& flags)> add;
    std::function<SettingValue()> value; ///< of the field, now; empty: a file, which is no setting
    std::string placeholder;             ///< "N"; empty: a flag
    std::string values = {};             ///< "1 to 65536", "box, b-spline"; empty: any
    std::vector<std::string> names = {}; ///< of a choice
};

/// An inclusive range of numbers.
struct NumberRange {
    double low;
    double high;
};

/// Joins names with commas: "box, b-spline".
std::string joined(const std::vector<std::string>& names);

/// Returns the text of a range for the options table: "1 to 65536".
std::string text_of(NumberRange range);

/// Returns a number as a setting: whole numbers as std::uint64_t, others as double.
template <typename Number>
SettingValue number_value(Number number)
{
    if constexpr (std::is_floating_point_v<Number>)
        return static_cast<double>(number);
    else
        return static_cast<std::uint64_t>(number);
}

template <typename Number>
SettingValue number_value(const std::optional<Number>& number)
{
    return number ? number_value(*number) : SettingValue();
}

/// Makes an option field for a number: an unsigned, std::uint64_t, float or double, or a
/// std::optional<std::uint64_t>.
template <typename Number>
OptionField number_field(Number& into, NumberRange range, std::string placeholder = "N");

/// Makes an option field for a number that equals `none` until the option is given.
template <typename Number>
OptionField number_or_none_field(Number& into, Number none, NumberRange range,
                                 std::string placeholder = "N")
{
    OptionField out = number_field(into, range, std::move(placeholder));
    out.value = [&into, none] { return into == none ? SettingValue() : number_value(into); };
    return out;
}

/// Makes an option field for any number that the seed can hold.
OptionField seed_field(std::uint64_t& into);

/// Makes an option field for one of some names.  set: gets the name that is given.
OptionField name_field(std::vector<std::string> names, std::function<void(const std::string&)> set,
                       std::function<SettingValue()> value, std::string placeholder = "NAME");

/// Makes an option field for one of `choices`, which must outlive the field.
template <typename Value>
OptionField choice_field(Value& into, std::span<const Choice<Value>> choices,
                         std::string placeholder = "NAME")
{
    std::vector<std::string> names;
    for (const Choice<Value>& choice : choices)
        names.emplace_back(choice.name);
    return name_field(
        std::move(names),
        [&into, choices](const std::string& name) { into = value_of(choices, name); },
        [&into, choices] { return SettingValue(std::string(name_of(choices, into))); },
        std::move(placeholder));
}

/// Makes an option field for a flag, which is true once the option is given.
OptionField flag_field(bool& into);

/// Makes an option field for text; empty text counts as not given.
OptionField text_field(std::string& into, std::string placeholder);

/// Makes an option field for text that may be given several times; the value joins all texts with
/// commas.
OptionField texts_field(std::vector<std::string>& into, std::string placeholder);

/// Makes an option field for a file or folder.
OptionField file_field(std::filesystem::path& into, std::string placeholder = "FILE");

/// Makes an option field for several files, each given by its own option.
OptionField files_field(std::vector<std::filesystem::path>& into);

/// Makes an option field for a width and height in pixels, a width alone, or a percentage of the
/// field's default.
OptionField size_field(PictureSize& into);

/// Makes an option field for text that `parse` reads.  `parse` throws CLI::ValidationError or
/// InputError for wrong text.
OptionField parsed_field(std::function<void(const std::string&)> parse,
                         std::function<SettingValue()> value, std::string placeholder);

} // namespace hipmap
