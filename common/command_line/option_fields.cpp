#include "common/command_line/option_fields.h"

#include "common/command_line/command_line.h"

namespace hipmap {

namespace {

CLI::Option* add_parsed(CLI::App& app, const std::string& flags,
                        const std::function<void(const std::string&)>& parse)
{
    return app.add_option_function<std::string>(flags, parse);
}

SettingValue value_or_none(std::string text)
{
    return text.empty() ? SettingValue() : SettingValue(std::move(text));
}

/// "512x384", or "512" while the height follows from the camera.
std::string size_text(PictureSize size)
{
    const std::string width = std::to_string(size.width);
    return size.height == 0 ? width : width + "x" + std::to_string(size.height);
}

} // namespace

std::string text_of(NumberRange range)
{
    return plain_number(range.low) + " to " + plain_number(range.high);
}

std::string joined(const std::vector<std::string>& names)
{
    std::string out;
    for (const std::string& name : names)
        out += (out.empty() ? "" : ", ") + name;
    return out;
}

template <typename Number>
OptionField number_field(Number& into, NumberRange range, std::string placeholder)
{
    return {.add =
                [&into, range](CLI::App& app, const std::string& flags) {
                    return app.add_option(flags, into)->check(finite_in(range.low, range.high));
                },
            .value = [&into] { return number_value(into); },
            .placeholder = std::move(placeholder),
            .values = text_of(range)};
}

template OptionField number_field(unsigned&, NumberRange, std::string);
template OptionField number_field(std::uint64_t&, NumberRange, std::string);
template OptionField number_field(float&, NumberRange, std::string);
template OptionField number_field(double&, NumberRange, std::string);
template OptionField number_field(std::optional<std::uint64_t>&, NumberRange, std::string);

OptionField name_field(std::vector<std::string> names, std::function<void(const std::string&)> set,
                       std::function<SettingValue()> value, std::string placeholder)
{
    OptionField out = parsed_field(std::move(set), std::move(value), std::move(placeholder));
    out.add = [add = out.add, names](CLI::App& app, const std::string& flags) {
        return add(app, flags)->check(CLI::IsMember(names));
    };
    out.values = joined(names);
    out.names = std::move(names);
    return out;
}

OptionField seed_field(std::uint64_t& into)
{
    return {.add = [&into](CLI::App& app,
                           const std::string& flags) { return app.add_option(flags, into); },
            .value = [&into] { return number_value(into); },
            .placeholder = "N"};
}

OptionField flag_field(bool& into)
{
    return {.add = [&into](CLI::App& app,
                           const std::string& flags) { return app.add_flag(flags, into); },
            .value = [&into] { return SettingValue(into); },
            .placeholder = ""};
}

OptionField text_field(std::string& into, std::string placeholder)
{
    return {.add = [&into](CLI::App& app,
                           const std::string& flags) { return app.add_option(flags, into); },
            .value = [&into] { return value_or_none(into); },
            .placeholder = std::move(placeholder)};
}

OptionField texts_field(std::vector<std::string>& into, std::string placeholder)
{
    return {.add =
                [&into](CLI::App& app, const std::string& flags) {
                    return app.add_option(flags, into)->allow_extra_args(false);
                },
            .value = [&into] { return value_or_none(joined(into)); },
            .placeholder = std::move(placeholder)};
}

OptionField file_field(std::filesystem::path& into, std::string placeholder)
{
    return {.add = [&into](CLI::App& app,
                           const std::string& flags) { return app.add_option(flags, into); },
            .value = {},
            .placeholder = std::move(placeholder)};
}

OptionField files_field(std::vector<std::filesystem::path>& into)
{
    return {.add =
                [&into](CLI::App& app, const std::string& flags) {
                    return app.add_option(flags, into)->allow_extra_args(false);
                },
            .value = {},
            .placeholder = "FILE"};
}

OptionField size_field(PictureSize& into)
{
    return parsed_field([&into](const std::string& text) { into = parse_picture_size(text, into); },
                        [&into] { return SettingValue(size_text(into)); }, "WxH|W|P%");
}

OptionField parsed_field(std::function<void(const std::string&)> parse,
                         std::function<SettingValue()> value, std::string placeholder)
{
    return {.add =
                [parse = std::move(parse)](CLI::App& app, const std::string& flags) {
                    return add_parsed(app, flags, parse);
                },
            .value = std::move(value),
            .placeholder = std::move(placeholder)};
}

} // namespace hipmap
