#include "render/load_frame.h"

#include "common/partition/partition_file.h"
#include "render/effects/drop_effects.h"
#include "render/run_plan.h"
#include "render/shading/part_touching_faces.h"

namespace hipmap {

namespace {

void choose_reflections(const RenderArguments& arguments, LoadedScene& loaded)
{
    if (arguments.diffuse)
        loaded.scene.diffuse_model = *arguments.diffuse;
    else if (loaded.scene.diffuse_model == DiffuseModel::burley)
        loaded.audit.assumed.push_back(
            "matt surfaces reflect as in the Blender that wrote the file (Burley's diffuse; "
            "--diffuse lambert is glTF's own)");
    for (Material& material : loaded.scene.materials)
        material.energy_compensation = arguments.energy_compensation;
}

void choose_sky_picture(const RenderArguments& arguments, LoadedScene& loaded)
{
    if (!arguments.sky.picture.empty()) {
        loaded.scene.environment = Rgb(0);
        loaded.scene.environment_picture = arguments.sky.picture;
        loaded.scene.environment_strength = 1;
        loaded.scene.environment_turn_deg = 0;
    }
    if (!loaded.scene.environment_picture.empty())
        loaded.audit.found.push_back("a picture of the sky, " + loaded.scene.environment_picture);
}

/// As many as a pass has samples: then photons cost a small part of it wherever rays cost more, and
/// are about as dense as what looks at them.  Within bounds: few are of no use, and maps of many
/// would fill the memory.
std::uint64_t default_photons(const PictureSize& size, int samples)
{
    const std::uint64_t pixels = static_cast<std::uint64_t>(size.width) * size.height;
    return std::clamp<std::uint64_t>(pixels * samples, 200'000, 2'000'000);
}

} // namespace

LoadedScene load_at(const RenderArguments& arguments, SceneSource& source,
                    std::optional<double> time)
{
    LoadedScene loaded = source.at(time, !arguments.frames.asked());
    choose_reflections(arguments, loaded);
    choose_sky_picture(arguments, loaded);
    return loaded;
}

Scene load_moment(const RenderArguments& arguments, SceneSource& source, double time,
                  const Partition& partition, const EffectPlan& effects)
{
    Scene now = load_at(arguments, source, time).scene;
    part_touching_faces(now, partition);
    drop_effects(now, effects);
    return now;
}

FrameScene load_frame(RenderArguments& arguments, SceneSource& source)
{
    FrameScene out;
    out.loaded = load_at(arguments, source, arguments.scene_options.time);
    Scene& scene = out.loaded.scene;
    const PictureSize size = complete_size(arguments.size, scene.cameras[scene.camera].aspect);
    if (!arguments.photons)
        arguments.photons = default_photons(size, arguments.render.samples);
    arguments.size = size;
    arguments.diffuse = scene.diffuse_model;
    arguments.render.width = size.width;
    arguments.render.height = size.height;
    arguments.render.photons = *arguments.photons;
    out.partition = read_partition(arguments.partition);
    check_partition_of(out.partition, scene, arguments.partition);
    out.motion = find_motion(scene, shutter_time(arguments),
                             [&](double time) { return load_at(arguments, source, time).scene; });
    part_touching_faces(scene, out.partition);
    out.effects = plan_run(arguments, scene, out.partition, out.motion.names);
    return out;
}

} // namespace hipmap
