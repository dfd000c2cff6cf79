#include "common/file/output_file.h"
#include "common/image/image_format.h"
#include "common/input_error.h"
#include "common/scene/print_audit.h"
#include "common/stopwatch.h"
#include "render/former_frame.h"
#include "render/integrator/moving_source.h"
#include "render/load_frame.h"
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

/// The state in the file, if there is one; refuses another render's.
std::optional<RenderState> find_state(const RenderArguments& arguments,
                                      const std::vector<Setting>& settings)
{
    if (!std::filesystem::exists(arguments.state))
        return std::nullopt;
    RenderState found = read_state(arguments.state);
    check_settings(arguments.state, found.settings, settings);
    return found;
}

RenderState begin_or_go_on(const RenderArguments& arguments, const PassSource& source,
                           std::vector<Setting> settings, const std::optional<RenderState>& found,
                           Report& report)
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

/// Passes of the scene as it is, or of its moments while the shutter is open.
PassSource make_source(const RenderArguments& arguments, const RenderScene& scene,
                       const EffectPlan& effects, SceneSource& source, RenderStatistics& statistics,
                       PhotonCache* cache)
{
    if (!effects.has(Effect::motion_blur))
        return make_pass_source(scene, arguments.render, statistics, cache);
    const auto at = [&, shutter = shutter_time(arguments)](double share) {
        return load_moment(arguments, source, shutter.at(share), scene.partition, effects);
    };
    return make_moving_source({scene, at}, arguments.render, statistics);
}

/// What is rendered, and how long it took to come to it.
struct Job {
    const LoadedScene& loaded;
    const Partition& partition;
    SkyPicture sky;
    std::vector<Setting> settings;
    std::optional<RenderState> found; ///< to go on with
};

/// Renders a frame.  former: may be null.
RenderedFrame render_job(const RenderArguments& arguments, Job job, SceneSource& source,
                         FormerFrame* former, RunStatistics& run, Report& report)
{
    PhotonCache* cache = nullptr;
    if (former != nullptr && !run.effects.has(Effect::motion_blur))
        cache = &cache_for(*former, job.loaded.scene, job.partition, job.sky,
                           arguments.photon_cache_mib);
    const Stopwatch building;
    const RenderScene scene(job.loaded.scene, job.partition, std::move(job.sky));
    run.seconds_rays = building.seconds();
    RenderedFrame out;
    const PassSource passes =
        make_source(arguments, scene, run.effects, source, out.statistics, cache);
    out.state = begin_or_go_on(arguments, passes, job.settings, job.found, report);
    out.result = render_with_progress(arguments, passes, out.state, report);
    if (cache != nullptr && cache->served > 0)
        report.line("photons of " + std::to_string(cache->served) +
                    " passes are those of the frame before: only the camera has moved");
    return out;
}

/// The same, or the frame before if it shows the same.
RenderedFrame render_or_take(const RenderArguments& arguments, Job job, SceneSource& source,
                             FormerFrame* former, RunStatistics& run, Report& report)
{
    if (former == nullptr)
        return render_job(arguments, std::move(job), source, former, run, report);
    if (former->rendered && former->settings == job.settings && !job.found) {
        report.line("nothing has moved since the frame before: its image serves");
        if (!arguments.state.empty())
            write_state(arguments.state, former->rendered->state);
        return *former->rendered;
    }
    std::vector<Setting> settings = job.settings;
    const bool anew = !job.found;
    RenderedFrame out = render_job(arguments, std::move(job), source, former, run, report);
    former->settings = std::move(settings);
    former->rendered.reset();
    if (anew && out.result.reason != StopReason::caller)
        former->rendered = out;
    return out;
}

/// Writes what was asked for.
void write_results(const RenderArguments& arguments, const Scene& scene, const Partition& partition,
                   const RenderedFrame& frame, RunStatistics& run, Report& report)
{
    print_statistics(arguments, frame.statistics, frame.state.film, report);
    print_error(arguments, frame.state, report);
    const Stopwatch writing;
    run.exposure_ev = write_images(arguments.images, frame.result.image, frame.state.film,
                                   frame.state.checks, arguments.exposure_ev, report);
    if (!arguments.error_image.empty())
        run.error_image =
            write_error_image(arguments.error_image, frame.state.film, frame.state.checks, report);
    run.seconds_write = writing.seconds();
    run.warnings = report.warnings();
    run.ended_by = frame.result.reason;
    if (arguments.statistics.empty())
        return;
    write_file(arguments.statistics,
               statistics_json(arguments, scene, partition, frame.statistics, frame.state, run));
    report.line("wrote " + arguments.statistics.string());
}

/// former: of the frame before, and then of this one; null: there is one frame alone.
int render(RenderArguments& arguments, SceneSource& source, FormerFrame* former)
{
    Report report;
    RunStatistics run;
    const ThreadLimit threads(arguments.threads);

    const Stopwatch reading;
    const FrameScene frame = load_frame(arguments, source);
    run.effects = frame.effects;
    if (arguments.explain) {
        print_audit(report, frame.loaded.audit);
        explain(run.effects, report);
        return kExitDone;
    }
    SkyPicture sky = load_sky(frame.loaded.scene, arguments.sky.turn_deg);
    std::vector<Setting> settings =
        settings_of(arguments, frame.loaded.scene, frame.partition, sky);
    if (run.effects.has(Effect::motion_blur))
        settings.push_back(frame.motion.setting);
    std::optional<RenderState> found = find_state(arguments, settings);
    if (arguments.frames.asked())
        report.line("frame " + std::to_string(arguments.frames.first));
    print_audit(report, frame.loaded.audit);
    report.line("effects: " + list_effects(run.effects) + " (--explain says why)");
    run.seconds_scene = reading.seconds();
    run.audit = frame.loaded.audit;

    const RenderedFrame rendered = render_or_take(
        arguments,
        {frame.loaded, frame.partition, std::move(sky), std::move(settings), std::move(found)},
        source, former, run, report);
    write_results(arguments, frame.loaded.scene, frame.partition, rendered, run, report);
    if (rendered.result.reason == StopReason::caller) {
        report.line("stopped by a signal after " +
                    std::to_string(count(rendered.state.film.passes)) +
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
    FormerFrame former;
    const bool further = arguments.frames.last > arguments.frames.first;
    return for_each_frame_of(arguments, [&](RenderArguments one) {
        return render(one, source, further ? &former : nullptr);
    });
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
    hipmap::add_arguments(app, arguments);
    if (const std::optional<int> code = hipmap::parse_arguments(app, argc, argv))
        return *code;
    hipmap::complete_arguments(arguments);
    arguments.command = hipmap::command_of("render", argc, argv);
    return hipmap::render_frames(arguments);
}

/// argv begins with "merge".
int merge_main(int argc, char** argv)
{
    hipmap::MergeArguments arguments;
    CLI::App app("Adds up the passes of states of one render, and writes their image.",
                 "render merge");
    hipmap::add_arguments(app, arguments);
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
