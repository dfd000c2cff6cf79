#include "render/prepare_frame.h"

#include "common/partition/expand_copies.h"
#include "common/partition/partition_file.h"
#include "common/scene/store_copies.h"
#include "common/stopwatch.h"
#include "render/effects/drop_effects.h"
#include "render/fit_memory.h"
#include "render/load_sky.h"
#include "render/run_plan.h"
#include "render/settings.h"
#include "render/shading/part_touching_faces.h"

namespace hipmap {

namespace {

/// The option adds to what the look has.
void compensate_energy(const RenderArguments& arguments, LoadedScene& loaded)
{
    for (Material& material : loaded.scene.materials)
        material.energy_compensation |= arguments.energy_compensation;
}

void choose_environment_map(const RenderArguments& arguments, LoadedScene& loaded)
{
    if (!arguments.sky.map_file.empty()) {
        loaded.scene.environment = Rgb(0);
        loaded.scene.environment_map_file = arguments.sky.map_file;
        loaded.scene.environment_strength = 1;
        loaded.scene.environment_turn_deg = 0;
    }
    if (!loaded.scene.environment_map_file.empty())
        loaded.audit.found.push_back("environment map " + loaded.scene.environment_map_file);
}

/// Fills in what follows from the scene.
void complete_by_scene(RenderArguments& arguments, const Scene& scene)
{
    const PictureSize size = complete_size(arguments.size, scene.cameras[scene.camera].aspect);
    if (!arguments.photons)
        arguments.photons = default_photons(size, arguments.render.samples);
    arguments.size = size;
    arguments.scene_options.look = choice_of(scene.look);
    arguments.render.width = size.width;
    arguments.render.height = size.height;
    if (arguments.crop)
        arguments.render.crop = pixels_of(*arguments.crop, size);
    arguments.crop.reset();
    if (!arguments.render.crop.empty())
        arguments.crop = crop_of(arguments.render.crop);
    arguments.render.photons = *arguments.photons;
    if (arguments.tile) {
        const PixelRect all = rendered_pixels(arguments.render);
        arguments.render.crop = pixels_of(*arguments.tile, all);
        arguments.tiled = arguments.render.crop == all ? PixelRect() : all;
        if (arguments.tiled.empty() && !arguments.crop)
            arguments.render.crop = {};
    }
}

/// Throws OtherState unless a state has the pixels that are rendered, and the same passes of each.
void check_pixels(const std::filesystem::path& path, const RenderState& found,
                  const RenderArguments& arguments)
{
    const char* const cure = "render the same --tile, or use another file";
    if (pixels_of(found.film) != rendered_pixels(arguments.render) ||
        image_of(found) != (arguments.tiled.empty() ? pixels_of(found.film) : arguments.tiled))
        throw OtherState(path.string() + ": holds another tile of the image", cure);
    if (!found.film.parts.empty())
        throw OtherState(path.string() + ": holds different passes of different tiles",
                         "render the tasks that are missing and merge their states with it");
}

/// Returns the state in the file, if there is one.  That of another render is refused, or renamed
/// and noted in the audit where that was asked for.
std::optional<RenderState> find_state(const RenderArguments& arguments,
                                      const std::vector<Setting>& settings, SceneAudit& audit)
{
    const OutputFiles& files = arguments.files;
    if (!std::filesystem::exists(files.state))
        return std::nullopt;
    try {
        RenderState found = read_state(files.state);
        check_settings(files.state, found.settings, settings);
        check_pixels(files.state, found, arguments);
        return found;
    } catch (const OtherState& other) {
        if (!files.replace_state)
            throw;
        const std::filesystem::path old = files.state.string() + ".old";
        std::filesystem::rename(files.state, old);
        audit.assumed.push_back(other.difference + "; starting over, and " + old.string() +
                                " keeps the old passes");
        return std::nullopt;
    }
}

/// Stores faces as the partition and the options expect them.
void store_faces(const RenderArguments& arguments, TriangleMesh& mesh, Partition& partition)
{
    set_apart_for(partition, mesh, arguments.partition);
    if (mesh.copies.empty() || asks_for_shared(arguments.render.dissertation))
        return;
    partition = expand_copies(partition, mesh);
    store_copies(mesh);
}

} // namespace

LoadedScene load_at(const RenderArguments& arguments, SceneSource& source,
                    std::optional<double> time)
{
    LoadedScene loaded = source.at(time, !arguments.frames.asked());
    compensate_energy(arguments, loaded);
    choose_environment_map(arguments, loaded);
    return loaded;
}

Scene load_moment(const PreparedFrame& frame, const EffectPlan& effects, SceneSource& source,
                  double time)
{
    Scene now = load_at(frame.arguments, source, time).scene;
    part_touching_faces(now, frame.partition);
    drop_effects(now, effects);
    return now;
}

PreparedFrame prepare_frame(const RenderArguments& request, SceneSource& source)
{
    const Stopwatch reading;
    PreparedFrame out;
    RenderArguments& arguments = out.arguments;
    arguments = request;
    out.loaded = load_at(arguments, source, arguments.scene_options.time);
    Scene& scene = out.loaded.scene;
    complete_by_scene(arguments, scene);
    out.partition = read_partition(arguments.partition);
    check_partition_of(out.partition, scene, arguments.partition);
    out.motion = find_motion(scene, shutter_time(arguments),
                             [&](double time) { return load_at(arguments, source, time).scene; });
    store_faces(arguments, scene.mesh, out.partition);
    part_touching_faces(scene, out.partition);
    out.effects = plan_run(arguments, scene, out.partition, out.motion.names);
    if (arguments.explain)
        return out;
    out.sky = load_sky(scene, arguments.sky.turn_deg);
    fit_memory(out);
    out.settings = settings_of(arguments, scene, out.partition, out.sky);
    if (out.effects.has(Effect::motion_blur))
        out.settings.push_back(out.motion.setting);
    out.reading.add(reading);
    const Stopwatch reading_state;
    out.found = find_state(arguments, out.settings, out.loaded.audit);
    out.reading_state.add(reading_state);
    return out;
}

} // namespace hipmap
