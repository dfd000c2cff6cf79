#include "common/input_error.h"
#include "render/settings.h"

#include <CLI/CLI.hpp>
#include <catch2/catch.hpp>

#include <algorithm>
#include <map>
#include <set>

using namespace hipmap;

namespace {

/// What `render` makes of a command line, of which only the options are given.
RenderArguments parse(std::vector<std::string> options)
{
    RenderArguments arguments;
    CLI::App app("", "render");
    add_arguments(app, arguments);
    options.insert(options.begin(), {"scene.glb", "scene.hpm"});
    std::reverse(options.begin(), options.end()); // as CLI11 takes them
    app.parse(options);
    return arguments;
}

RenderArguments complete(RenderArguments arguments)
{
    arguments.files.images = {"image.png"};
    complete_arguments(arguments);
    return arguments;
}

std::string help_text()
{
    RenderArguments arguments;
    CLI::App app("", "render");
    add_arguments(app, arguments);
    return app.help();
}

/// The option with a value that is not its default; empty: none was found.
std::vector<std::string> changed_option(const OptionRow& row)
{
    std::vector<std::string> texts = row.field.names;
    texts.insert(texts.end(), {"7", "0.25", "1,2,3,4"});
    for (const std::string& text : texts) {
        try {
            const std::vector<std::string> option{"--" + row.name, text};
            if (values_of(parse(option)) != values_of({}))
                return option;
        } catch (const CLI::ParseError&) { // not a value of this option
        }
    }
    return {};
}

std::vector<Setting> settings_of_tiny(const RenderArguments& arguments)
{
    Scene scene;
    scene.cameras.resize(1);
    return settings_of(arguments, scene, {}, {});
}

} // namespace

TEST_CASE("settings: no two options share a name, and each has a section and a help", "[settings]")
{
    RenderArguments arguments;
    std::set<std::string> names;
    for (const OptionRow& row : option_rows(arguments)) {
        INFO(row.name);
        CHECK(names.insert(row.name).second);
        CHECK(std::string(row.section) != "");
        CHECK(row.help != "");
    }
}

TEST_CASE("settings: --help states the defaults that the structs have", "[settings]")
{
    const std::string help = help_text();
    RenderArguments arguments;
    for (const OptionRow& row : option_rows(arguments)) {
        INFO(row.name);
        CHECK_THAT(help, Catch::Contains("--" + row.name));
        const std::string preset = default_text(row);
        const std::string stated = preset.empty() ? row.help : row.help + " [" + preset + "]";
        CHECK_THAT(help, Catch::Contains(stated));
        if (row.field.value && !row.field.placeholder.empty() &&
            row.field.value() != SettingValue())
            CHECK(preset != "");
    }
}

TEST_CASE("settings: a command line without options leaves every field as it was", "[settings]")
{
    CHECK(values_of(parse({})) == values_of(RenderArguments()));
}

TEST_CASE("settings: each option that changes passes is in the settings of a state and changes "
          "these alone",
          "[settings]")
{
    RenderArguments arguments;
    const std::vector<Setting> settings = settings_of_tiny({});
    std::size_t checked = 0;
    for (const OptionRow& row : option_rows(arguments)) {
        if (row.changes != Changes::passes)
            continue;
        INFO(row.name);
        const std::vector<std::string> option = changed_option(row);
        REQUIRE(!option.empty());
        const std::vector<Setting> other = settings_of_tiny(parse(option));
        REQUIRE(other.size() == settings.size());
        for (std::size_t i = 0; i < settings.size(); ++i)
            CHECK((other[i] != settings[i]) == (settings[i].name == row.name));
        ++checked;
    }
    CHECK(checked > 10);
}

TEST_CASE("settings: options that change nothing or the scene alone are not in a state's settings",
          "[settings]")
{
    const std::vector<Setting> settings = settings_of_tiny({});
    const RenderArguments other = parse(
        {"--passes", "3", "--threads", "2", "--exposure", "1", "--camera", "A", "--exclude", "B"});
    CHECK(settings_of_tiny(other) == settings);
}

TEST_CASE("settings: values are typed", "[settings]")
{
    const RenderArguments arguments = complete(
        parse({"--photons", "5000", "--alpha", "0.5", "--time", "3", "--size", "8x9", "--error",
               "5%", "--neighbours", "20", "--exclude", "A", "--exclude", "B"}));
    std::map<std::string, SettingValue> values;
    for (const Setting& setting : values_of(arguments))
        values[setting.name] = setting.value;
    CHECK(values["photons"] == SettingValue(std::uint64_t{5000}));
    CHECK(values["alpha"] == SettingValue(0.5));
    CHECK(values["time"] == SettingValue(3.0));
    CHECK(values["passes"] == SettingValue());
    CHECK(values["size"] == SettingValue("8x9"));
    CHECK(values["error"] == SettingValue(0.05));
    CHECK(values["exclude"] == SettingValue("A, B"));
    CHECK(values["local-min"] == SettingValue(std::uint64_t{200}));
    CHECK(values["integrator"] == SettingValue("progressive"));
    CHECK(values["quote"] == SettingValue(false));
    CHECK(values.count("output") == 0);
}

TEST_CASE("settings: every name of a choice is read as the value that it is the name of",
          "[settings]")
{
    RenderArguments arguments;
    for (const OptionRow& row : option_rows(arguments))
        for (const std::string& name : row.field.names) {
            INFO(row.name << " " << name);
            const RenderArguments parsed = parse({"--" + row.name, name});
            const std::vector<Setting> values = values_of(parsed);
            CHECK(std::find(values.begin(), values.end(), Setting{row.name, name}) != values.end());
        }
}

TEST_CASE("settings: what follows from other options is filled in", "[settings]")
{
    CHECK(complete({}).stops.passes == kDefaultPasses);
    CHECK(complete(parse({"--error", "5"})).stops.passes == StopRules().passes);
    CHECK(complete({}).render.dissertation.local_min == 10 * MapOptions().neighbours);
    CHECK(complete(parse({"--local-min", "7"})).render.dissertation.local_min == 7);
    CHECK(complete(parse({"--quote", "--error", "5", "--state", "a.state"})).stops.passes ==
          kBatches);
}

TEST_CASE("settings: values that do not go together are refused, by name", "[settings]")
{
    const std::vector<std::vector<std::string>> refused{
        {"--alpha", "0.5", "--integrator", "path"},
        {"--irradiance", "precomputed", "--integrator", "direct"},
        {"--direct", "photons"},
        {"--direct", "photons", "--integrator", "direct", "--maps", "none"},
        {"--estimate", "thesis"}};
    for (const std::vector<std::string>& options : refused) {
        INFO(options[0]);
        CHECK_THROWS_WITH(complete(parse(options)), Catch::Contains(options[0]));
    }
    CHECK_NOTHROW(complete(parse({"--direct", "photons", "--integrator", "direct"})));
    CHECK_NOTHROW(complete(parse({"--alpha", "0.5"})));
    RenderArguments arguments;
    const std::vector<OptionRow> rows = option_rows(arguments);
    for (const OptionRow& row : rows)
        for (const OnlyWith& rule : row.only_with) {
            INFO(row.name);
            const auto other = std::find_if(rows.begin(), rows.end(), [&](const OptionRow& any) {
                return any.name == rule.option;
            });
            REQUIRE(other != rows.end());
            for (const std::string& value : rule.values)
                CHECK(std::count(other->field.names.begin(), other->field.names.end(), value) == 1);
        }
}

TEST_CASE("settings: a quality sets several options, and each of them overrides it", "[settings]")
{
    const RenderArguments draft = complete(parse({"--quality", "draft"}));
    CHECK(draft.render.integrator == Integrator::direct);
    CHECK(draft.stops.passes == 4);
    CHECK(draft.stops.seconds == 60);
    CHECK(draft.stops.error == 0);
    for (const bool first : {true, false}) {
        std::vector<std::string> options = {"--time", "5", "--error", "3%"};
        const std::vector<std::string> quality = {"--quality", "draft"};
        options.insert(first ? options.begin() : options.end(), quality.begin(), quality.end());
        const RenderArguments own = complete(parse(options));
        CHECK(own.stops.seconds == 5);
        CHECK(own.stops.error == 0.03);
        CHECK(own.render.integrator == Integrator::direct);
    }
    const RenderArguments path = parse({"--quality", "draft", "--integrator", "path"});
    CHECK(path.render.integrator == Integrator::path);
    CHECK(complete(parse({"--quality", "final"})).stops.seconds == StopRules().seconds);
    CHECK(complete(parse({"--quality", "good"})).stops.error == 0.05);
    const RenderArguments standard = complete(parse({"--quality", "standard"}));
    CHECK(standard.stops.passes == kDefaultPasses);
}

TEST_CASE("settings: a size in percent is a share of the default", "[settings]")
{
    const PictureSize half = parse({"--size", "50%"}).size;
    CHECK(half.width == RenderArguments().size.width / 2);
    CHECK(half.height == 0); // by the camera
    CHECK(parse({"--size", "0.01%"}).size.width == 1);
    for (const char* wrong : {"0%", "%", "-5%", "nan%", "1e9%", "5x%"})
        CHECK_THROWS_WITH(parse({"--size", wrong}), Catch::Contains("write WIDTH"));
}
