#include "common/file/output_file.h"
#include "common/image/image_format.h"
#include "common/input_error.h"
#include "common/partition/partition_file.h"
#include "common/scene/print_audit.h"
#include "common/stopwatch.h"
#include "render/effects/drop_effects.h"
#include "render/integrator/moving_source.h"
#include "render/load_sky.h"
#include "render/merge.h"
#include "render/outputs.h"
#include "render/print_results.h"
#include "render/run_plan.h"
#include "render/settings.h"
#include "render/shutter.h"
#include "render/statistics.h"

#include <algorithm>
#include <csignal>

namespace hipmap {

namespace {

std::atomic<bool> g_stop{false};

extern "C" void ask_to_stop(int)
{
    g_stop = true;
}

void check_outputs(const RenderArguments& arguments)
{
    for (const std::filesystem::path& image : arguments.images)
        check_writable(image);
    for (const std::filesystem::path& file :
         {arguments.error_image, arguments.statistics, arguments.state})
        if (!file.empty())
            check_writable(file);
}

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

Partition load_partition(const RenderArguments& arguments, const Scene& scene)
{
    Partition partition = read_partition(arguments.partition);
    check_partition_of(partition, scene, arguments.partition);
    return partition;
}

/// The state in the file, if there is one; refuses another render's.
std::optional<RenderState> find_state(const RenderArguments& arguments,
                                      const std::vector<std::string>& settings)
{
    if (!std::filesystem::exists(arguments.state))
        return std::nullopt;
    RenderState found = read_state(arguments.state);
    check_settings(arguments.state, found.settings, settings);
    return found;
}

RenderState begin_or_go_on(const RenderArguments& arguments, const PassSource& source,
                           std::vector<std::string> settings,
                           const std::optional<RenderState>& found, Report& report)
{
    RenderState state = begin_state(source, std::move(settings));
    if (!found)
        return state;
    merge_state(state, *found, arguments.state);
    report.line("going on with " + std::to_string(count(state.film.passes)) + " passes of " +
                arguments.state.string());
    return state;
}

std::string describe_stops(const StopRules& stops)
{
    std::string text;
    if (stops.passes < kMostPasses)
        text += ", " + std::to_string(stops.passes) + (stops.passes == 1 ? " pass" : " passes");
    if (std::isfinite(stops.seconds))
        text += ", " + format_seconds(stops.seconds);
    if (stops.error > 0)
        text += ", to an error of " + percent(stops.error);
    return text;
}

RunResult render_with_progress(const RenderArguments& arguments, const PassSource& source,
                               RenderState& state, Report& report)
{
    std::signal(SIGINT, ask_to_stop);
    std::signal(SIGTERM, ask_to_stop);
    RunControl control;
    control.progress = [&report](const RunProgress& progress) {
        std::string note =
            std::to_string(progress.passes) + (progress.passes == 1 ? " pass" : " passes");
        if (progress.error)
            note += ", error " + percent(progress.error->error);
        report.progress(progress.done, note);
    };
    control.stop = &g_stop;
    if (!arguments.state.empty())
        control.save = [&](const RenderState& now) { write_state(arguments.state, now); };
    report.begin("rendering " + std::to_string(source.width) + "x" + std::to_string(source.height) +
                 describe_stops(arguments.stops));
    RunResult out = run_passes(source, arguments.stops, control, state);
    report.end();
    if (!arguments.state.empty())
        write_state(arguments.state, state);
    return out;
}

LoadedScene load_at(const RenderArguments& arguments, SceneSource& source,
                    std::optional<double> time)
{
    LoadedScene loaded = source.at(time, !arguments.frames.asked());
    choose_reflections(arguments, loaded);
    choose_sky_picture(arguments, loaded);
    return loaded;
}

/// Loads the scene and completes the options by it.
LoadedScene load(RenderArguments& arguments, SceneSource& source)
{
    LoadedScene loaded = load_at(arguments, source, arguments.scene_options.time);
    const Scene& scene = loaded.scene;
    const PictureSize size = complete_size(arguments.size, scene.cameras[scene.camera].aspect);
    arguments.render.width = size.width;
    arguments.render.height = size.height;
    return loaded;
}

/// Passes of the scene as it is, or of its moments while the shutter is open.
PassSource make_source(const RenderArguments& arguments, const RenderScene& scene,
                       const EffectPlan& effects, SceneSource& source, RenderStatistics& statistics)
{
    if (!effects.has(Effect::motion_blur))
        return make_pass_source(scene, arguments.render, statistics);
    const auto at = [&, shutter = shutter_time(arguments)](double share) {
        Scene now = load_at(arguments, source, shutter.at(share)).scene;
        drop_effects(now, effects);
        return now;
    };
    return make_moving_source({scene, at}, arguments.render, statistics);
}

int render(RenderArguments& arguments, SceneSource& source)
{
    Report report;
    RunStatistics run;
    const ThreadLimit threads(arguments.threads);

    const Stopwatch reading;
    LoadedScene loaded = load(arguments, source);
    const Partition partition = load_partition(arguments, loaded.scene);
    const ShutterMotion motion =
        find_motion(loaded.scene, shutter_time(arguments),
                    [&](double time) { return load_at(arguments, source, time).scene; });
    run.effects = plan_run(arguments, loaded.scene, partition, motion.names);
    if (arguments.explain) {
        print_audit(report, loaded.audit);
        explain(run.effects, report);
        return kExitDone;
    }
    SkyPicture sky = load_sky(loaded.scene, arguments.sky.turn_deg);
    std::vector<std::string> settings = settings_of(arguments.render, loaded.scene, partition, sky);
    if (run.effects.has(Effect::motion_blur))
        settings.push_back(motion.setting);
    const std::optional<RenderState> found = find_state(arguments, settings);
    if (arguments.frames.asked())
        report.line("frame " + std::to_string(arguments.frames.first));
    print_audit(report, loaded.audit);
    report.line("effects: " + list_effects(run.effects) + " (--explain says why)");
    run.seconds_scene = reading.seconds();

    const Stopwatch building;
    const RenderScene render_scene(loaded.scene, partition, std::move(sky));
    run.seconds_rays = building.seconds();

    RenderStatistics statistics;
    const PassSource passes = make_source(arguments, render_scene, run.effects, source, statistics);
    RenderState state = begin_or_go_on(arguments, passes, settings, found, report);
    const RunResult rendered = render_with_progress(arguments, passes, state, report);
    print_statistics(arguments, statistics, state.film, report);
    print_error(arguments, state, report);

    const Stopwatch writing;
    run.exposure_ev = write_images(arguments.images, rendered.image, state.film, state.checks,
                                   arguments.exposure_ev, report);
    if (!arguments.error_image.empty())
        run.error_image =
            write_error_image(arguments.error_image, state.film, state.checks, report);
    run.seconds_write = writing.seconds();
    run.warnings = report.warnings();
    run.audit = loaded.audit;
    run.ended_by = rendered.reason;
    if (!arguments.statistics.empty()) {
        write_file(arguments.statistics,
                   statistics_json(arguments, loaded.scene, partition, statistics, state, run));
        report.line("wrote " + arguments.statistics.string());
    }
    if (rendered.reason == StopReason::caller) {
        report.line("stopped by a signal after " + std::to_string(count(state.film.passes)) +
                    " passes; the image holds what was done");
        return kExitStopped;
    }
    return kExitDone;
}

int render_frames(const RenderArguments& arguments)
{
    for_each_frame_of(arguments, [](const RenderArguments& one) {
        check_outputs(one);
        return kExitDone;
    });
    const auto is_exposed = [](const std::filesystem::path& image) {
        const ImageFormat format = image_format(image);
        return format == ImageFormat::png || format == ImageFormat::ppm;
    };
    if (arguments.frames.last > arguments.frames.first && !arguments.exposure_ev &&
        std::any_of(arguments.images.begin(), arguments.images.end(), is_exposed))
        Report().line("assumed: each frame is exposed by itself, so brightness may jump "
                      "(--exposure EV holds it)");
    SceneSource source(arguments.scene, arguments.scene_options);
    return for_each_frame_of(arguments, [&](RenderArguments one) { return render(one, source); });
}

} // namespace

} // namespace hipmap

namespace {

int render_main(int argc, char** argv)
{
    hipmap::RenderArguments arguments;
    CLI::App app("Renders a scene with photon maps split along its partition.  `render merge` "
                 "adds up what several runs kept by --state; see render merge --help.",
                 "render");
    app.set_version_flag("--version", "render " HIPMAP_VERSION);
    hipmap::add_render_arguments(app, arguments);
    if (const std::optional<int> code = hipmap::parse_arguments(app, argc, argv))
        return *code;
    hipmap::complete_arguments(app, arguments);
    arguments.command = hipmap::command_of("render", argc, argv);
    return hipmap::render_frames(arguments);
}

/// argv begins with "merge".
int merge_main(int argc, char** argv)
{
    hipmap::MergeArguments arguments;
    CLI::App app("Adds up the passes of states of one render, and writes their image.",
                 "render merge");
    hipmap::add_merge_arguments(app, arguments);
    if (const std::optional<int> code = hipmap::parse_arguments(app, argc, argv))
        return *code;
    arguments.command = hipmap::command_of("render", argc + 1, argv - 1);
    return hipmap::merge_states(arguments);
}

} // namespace

int main(int argc, char** argv)
{
    const bool merge = argc > 1 && std::string_view(argv[1]) == "merge";
    return hipmap::run_tool(
        [&] { return merge ? merge_main(argc - 1, argv + 1) : render_main(argc, argv); });
}
