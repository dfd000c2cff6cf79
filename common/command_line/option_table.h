#pragma once

#include "common/command_line/option_fields.h"

namespace hipmap {

/// Says what depends on an option's value.
enum class Changes : std::uint8_t {
    nothing, ///< not the passes of an image: which files, when to end, how fast
    scene,   ///< what is rendered; states hold a hash of that
    passes,  ///< how a pass is computed; states hold the value
};

/// Headings under which options of both tools are listed.
inline constexpr const char* kFilesSection = "Files";
inline constexpr const char* kSceneSection = "Scene";
inline constexpr const char* kAnimationSection = "Animation";
inline constexpr const char* kRunSection = "Running";

/// Restricts a value of an option to some values of another option.
struct OnlyWith {
    std::string value;               ///< of this option; empty: any but the default
    std::string option;              ///< name of the other
    std::vector<std::string> values; ///< of the other
};

/// Everything known about an option.  The command line, help, documentation, statistics and render
/// state follow from it.
struct OptionRow {
    std::string name;       ///< "samples"
    const char* section;    ///< heading under which it is listed
    OptionField field;      ///< where its value goes; the value at first is the default
    std::string help;       ///< what it does
    std::string unset = {}; ///< what holds while it has no value; empty: nothing to say
    Changes changes = Changes::nothing;
    std::string flags = {}; ///< on the command line; empty: "--" and the name
    std::string needs = {}; ///< name of an earlier option without which this one is refused
    bool required = false;
    std::vector<OnlyWith> only_with = {};
};

/// Returns the text of a row's default: its current value, or what applies while it has none.
/// Empty for a flag, or where there is nothing to say.
std::string default_text(const OptionRow& row);

/// Adds an option for each row.  The fields must outlive the parsing.
void add_options(CLI::App& app, const std::vector<OptionRow>& rows);

/// Throws InputError for the first row whose value does not go with another row's value (OnlyWith).
/// defaults: rows of the same table, whose fields hold the defaults.
void check_combinations(const std::vector<OptionRow>& rows, const std::vector<OptionRow>& defaults);

/// Returns the options as Markdown tables, one for each section (docs/options.md).
std::string options_markdown(const std::vector<OptionRow>& rows);

/// Returns the options and the description of a program as JSON, for programs that read them:
/// "options" lists name, flags, section, placeholder (empty: a flag), values, choices, default,
/// help, and is_setting (false: the name of a file).
std::string options_json(const std::string& description, const std::vector<OptionRow>& rows);

/// Appends `more` to `rows`.
void append_rows(std::vector<OptionRow>& rows, std::vector<OptionRow> more);

} // namespace hipmap
