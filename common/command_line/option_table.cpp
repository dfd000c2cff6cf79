#include "common/command_line/option_table.h"

#include "common/input_error.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>

namespace hipmap {

namespace {

/// Formats a value as the table does, but short: 0.666667.
struct ShortText {
    template <typename Value>
    std::string operator()(const Value& value) const
    {
        return text_of(SettingValue(value));
    }
    std::string operator()(double number) const
    {
        std::ostringstream text;
        text << number;
        return text.str();
    }
};

std::string flags_of(const OptionRow& row)
{
    return row.flags.empty() ? "--" + row.name : row.flags;
}

std::string help_of(const OptionRow& row)
{
    const std::string preset = default_text(row);
    return preset.empty() ? row.help : row.help + " [" + preset + "]";
}

/// A cell of a table in Markdown.
std::string cell(std::string text)
{
    for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2)
        text.insert(at, 1, '\\');
    return " " + text + (text.empty() ? "|" : " |");
}

/// "`--samples N`".
std::string usage_of(const OptionRow& row)
{
    std::string flags = flags_of(row);
    if (const std::size_t comma = flags.find(','); comma != std::string::npos)
        flags.insert(comma + 1, " ");
    return "`" + flags + (row.field.placeholder.empty() ? "" : " " + row.field.placeholder) + "`";
}

/// The sections, in the order in which they first appear.
std::vector<std::string> sections_of(const std::vector<OptionRow>& rows)
{
    std::vector<std::string> out;
    for (const OptionRow& row : rows)
        if (std::find(out.begin(), out.end(), row.section) == out.end())
            out.emplace_back(row.section);
    return out;
}

/// What stands on the command line for the value of a row's field now; empty: it has none.
std::string value_text(const OptionRow& row)
{
    const SettingValue value = row.field.value ? row.field.value() : SettingValue();
    return value == SettingValue() ? "" : std::visit(ShortText(), value);
}

const OptionRow& row_of(const std::vector<OptionRow>& rows, const std::string& name)
{
    return *std::find_if(rows.begin(), rows.end(),
                         [&](const OptionRow& row) { return row.name == name; });
}

/// "global, shared or thesis".
std::string alternatives(const std::vector<std::string>& values)
{
    std::string out = values.front();
    for (std::size_t i = 1; i < values.size(); ++i)
        out += (i + 1 < values.size() ? ", " : " or ") + values[i];
    return out;
}

} // namespace

void check_combinations(const std::vector<OptionRow>& rows, const std::vector<OptionRow>& defaults)
{
    for (const OptionRow& row : rows)
        for (const OnlyWith& rule : row.only_with) {
            const std::string value = value_text(row);
            const std::string preset = value_text(row_of(defaults, row.name));
            const std::string other = value_text(row_of(rows, rule.option));
            const bool meant = rule.value.empty() ? value != preset : value == rule.value;
            if (!meant ||
                std::find(rule.values.begin(), rule.values.end(), other) != rule.values.end())
                continue;
            throw InputError("--" + row.name + " " + value + " needs --" + rule.option + " " +
                             alternatives(rule.values) + ", not " + other +
                             "; change it, or remove --" + row.name);
        }
}

std::string default_text(const OptionRow& row)
{
    if (!row.field.value || row.field.placeholder.empty())
        return row.unset;
    const SettingValue value = row.field.value();
    return value == SettingValue() ? row.unset : std::visit(ShortText(), value);
}

void add_options(CLI::App& app, const std::vector<OptionRow>& rows)
{
    for (const OptionRow& row : rows) {
        CLI::Option* const option = row.field.add(app, flags_of(row));
        option->description(help_of(row))->group(row.section)->required(row.required);
        if (!row.field.placeholder.empty())
            option->type_name(row.field.placeholder);
        if (!row.needs.empty())
            option->needs(app.get_option("--" + row.needs));
    }
    // For docs/options.md, and for manual pages, completion and the command hipmap.  Triggered
    // while the command line is parsed: fields still have their defaults then.
    const auto kept = std::make_shared<const std::vector<OptionRow>>(rows);
    app.add_flag_callback("--options-table",
                          [kept] { throw CLI::CallForVersion(options_markdown(*kept), 0); })
        ->trigger_on_parse()
        ->group("");
    app.add_flag_callback("--options-json",
                          [kept, &app] {
                              throw CLI::CallForVersion(options_json(app.get_description(), *kept),
                                                        0);
                          })
        ->trigger_on_parse()
        ->group("");
}

std::string options_json(const std::string& description, const std::vector<OptionRow>& rows)
{
    nlohmann::ordered_json out = {{"description", description},
                                  {"options", nlohmann::ordered_json::array()}};
    for (const OptionRow& row : rows)
        out["options"].push_back({{"name", row.name},
                                  {"flags", flags_of(row)},
                                  {"section", row.section},
                                  {"placeholder", row.field.placeholder},
                                  {"values", row.field.values},
                                  {"choices", row.field.names},
                                  {"default", default_text(row)},
                                  {"help", row.help},
                                  {"is_setting", static_cast<bool>(row.field.value)}});
    return out.dump(2);
}

std::string options_markdown(const std::vector<OptionRow>& rows)
{
    const bool states = std::any_of(rows.begin(), rows.end(), [](const OptionRow& row) {
        return row.changes == Changes::passes;
    });
    std::string out;
    for (const std::string& section : sections_of(rows)) {
        out += (out.empty() ? "" : "\n") + std::string("### ") + section + "\n\n";
        out += std::string("| option | values | default |") + (states ? " image |" : "") +
               " meaning |\n|---|---|---|" + (states ? "---|" : "") + "---|\n";
        for (const OptionRow& row : rows)
            if (row.section == section)
                out += "|" + cell(usage_of(row)) + cell(row.field.values) +
                       cell(default_text(row)) +
                       (states ? cell(row.changes == Changes::nothing ? "" : "yes") : "") +
                       cell(row.help) + "\n";
    }
    return out;
}

void append_rows(std::vector<OptionRow>& rows, std::vector<OptionRow> more)
{
    std::move(more.begin(), more.end(), std::back_inserter(rows));
}

} // namespace hipmap
