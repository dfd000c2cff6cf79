#include "common/command_line/scene_arguments.h"

#include <CLI/CLI.hpp>

namespace hipmap {

namespace {

constexpr Choice<LightUnits> kLightUnits[] = {
    {"spec", LightUnits::spec}, {"compat", LightUnits::compat}, {"raw", LightUnits::raw}};

constexpr double kMostRadiance = 1e12;
constexpr double kMostThreads = 4096;
constexpr double kMostMib = 1 << 24;

void parse_environment(const std::string& text, SceneOptions& options, SkyOptions& sky)
{
    double radiance = 0;
    const bool is_number = CLI::detail::lexical_cast(text, radiance);
    if (is_number && !(radiance >= 0 && radiance <= kMostRadiance))
        throw CLI::ValidationError("--environment", text + " is not a radiance from 0 to 1e12");
    sky.map_file = is_number ? "" : text;
    // With an environment map, the loader must not take the scene for one without light.
    options.environment = Rgb(is_number ? static_cast<float>(radiance) : 1.0f);
}

SettingValue environment_of(const SceneOptions& options, const SkyOptions& sky)
{
    if (!sky.map_file.empty())
        return sky.map_file;
    return options.environment ? SettingValue(double{options.environment->x}) : SettingValue();
}

OptionRow environment_row(SceneOptions& options, SkyOptions& sky)
{
    return {.name = "environment",
            .section = kSceneSection,
            .field = parsed_field(
                [&](const std::string& text) { parse_environment(text, options, sky); },
                [&] { return environment_of(options, sky); }, "RADIANCE|FILE"),
            .help = "Radiance of a uniform sky, W/(m2 sr), or an environment map in longitude and "
                    "latitude, .hdr, .exr or .pfm",
            .unset = "none; 1 if the scene has no light at all",
            .changes = Changes::scene};
}

} // namespace

std::vector<OptionRow> scene_rows(SceneOptions& options, SkyOptions& sky)
{
    return {{.name = "camera",
             .section = kSceneSection,
             .field = text_field(options.camera, "NAME"),
             .help = "Camera to use, by name",
             .unset = "the first in the file",
             .changes = Changes::scene},
            {.name = "light-units",
             .section = kSceneSection,
             .field = choice_field<LightUnits>(options.light_units, kLightUnits, "UNITS"),
             .help = "Units of the file's light intensities: spec (Blender's Standard), compat "
                     "(Unitless) or raw",
             .changes = Changes::scene},
            environment_row(options, sky),
            {.name = "environment-turn",
             .section = kSceneSection,
             .field = number_field(sky.turn_deg, {-360, 360}, "DEG"),
             .help = "Rotation of the environment map in degrees, counter-clockwise from above",
             .changes = Changes::scene},
            {.name = "exclude",
             .section = kSceneSection,
             .field = texts_field(options.exclude, "NAME"),
             .help = "Leave out the objects of this name; repeatable",
             .changes = Changes::scene}};
}

OptionRow threads_row(unsigned& threads)
{
    return {.name = "threads",
            .section = kRunSection,
            .field = number_field(threads, {0, kMostThreads}),
            .help = "Threads; 0: all cores"};
}

OptionRow texture_cache_row(double& mib)
{
    return {.name = "texture-cache",
            .section = kRunSection,
            .field = number_field(mib, {0, kMostMib}, "MIB"),
            .help = "MiB of memory for the pixels of textures. Where they need more, a temporary "
                    "file (in TMPDIR) holds them: slower, with the same image"};
}

OptionRow verbose_row(bool& verbose)
{
    return {.name = "verbose",
            .section = kRunSection,
            .field = flag_field(verbose),
            .help = "Print everything that was found in the scene and done with it"};
}

} // namespace hipmap
