#include "common/command_line/scene_arguments.h"

#include <map>

namespace hipmap {

namespace {

const std::map<std::string, LightUnits> kLightUnits = {
    {"spec", LightUnits::spec}, {"compat", LightUnits::compat}, {"raw", LightUnits::raw}};

constexpr double kMostRadiance = 1e12;

} // namespace

void add_scene_arguments(CLI::App& app, SceneOptions& options)
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
    app.add_option_function<double>(
           "--environment",
           [&options](double radiance) { options.environment = Rgb(static_cast<float>(radiance)); },
           "Radiance of a uniform sky, W/(m2 sr) [none; 1 if the scene has no light at all]")
        ->check(finite_in(0, kMostRadiance))
        ->type_name("RADIANCE");
    app.add_option("--exclude", options.exclude, "Leave out the objects of this name; repeatable")
        ->allow_extra_args(false)
        ->type_name("NAME");
}

} // namespace hipmap
