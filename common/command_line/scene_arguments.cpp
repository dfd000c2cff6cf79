#include "common/command_line/scene_arguments.h"

#include <map>

namespace hipmap {

namespace {

const std::map<std::string, LightUnits> kLightUnits = {
    {"spec", LightUnits::spec}, {"compat", LightUnits::compat}, {"raw", LightUnits::raw}};

constexpr double kMostRadiance = 1e12;

} // namespace

void add_scene_arguments(CLI::App& app, SceneOptions& options, SkyOptions& sky)
{
    app.add_option("--camera", options.camera, "Camera to use, by name [the first in the file]")
        ->type_name("NAME");
    app.add_option_function<std::string>(
           "--light-units",
           [&options](const std::string& name) { options.light_units = kLightUnits.at(name); },
           "What the file's lamp numbers mean: spec (Blender's Standard), compat (Unitless) or "
           "raw [spec]")
        ->check(CLI::IsMember(kLightUnits))
        ->type_name("UNITS");
    app.add_option_function<std::string>(
           "--environment",
           [&options, &sky](const std::string& text) {
               double radiance = 0;
               const bool is_number = CLI::detail::lexical_cast(text, radiance);
               if (is_number && !(radiance >= 0 && radiance <= kMostRadiance))
                   throw CLI::ValidationError("--environment",
                                              text + " is no radiance from 0 to 1e12");
               sky.picture = is_number ? "" : text;
               // With a picture, what is told of a scene without light does not hold.
               options.environment = Rgb(is_number ? static_cast<float>(radiance) : 1.0f);
           },
           "Radiance of a uniform sky, W/(m2 sr), or a picture of it by longitude and latitude, "
           ".hdr, .exr or .pfm [none; 1 if the scene has no light at all]")
        ->type_name("RADIANCE|FILE");
    app.add_option(
           "--environment-turn", sky.turn_deg,
           "Degrees that the picture of the sky is turned, counter-clockwise from above [0]")
        ->check(finite_in(-360, 360))
        ->type_name("DEG");
    app.add_option("--exclude", options.exclude, "Leave out the objects of this name; repeatable")
        ->allow_extra_args(false)
        ->type_name("NAME");
}

} // namespace hipmap
