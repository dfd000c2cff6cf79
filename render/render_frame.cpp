#include "render/render_frame.h"

#include "common/stopwatch.h"
#include "render/integrator/moving_source.h"
#include "render/outputs.h"

namespace hipmap {

namespace {

RenderState begin_or_resume(const PreparedFrame& frame, const PassSource& source, Report& report)
{
    RenderState state = begin_state(source, frame.settings);
    if (!frame.found)
        return state;
    merge_state(state, *frame.found, frame.arguments.files.state);
    report.line("resuming with " + std::to_string(count(state.film.passes)) + " passes from " +
                frame.arguments.files.state.string());
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
        text += ", until the error is " + percent(stops.error);
    return text;
}

RunResult render_with_progress(const RenderArguments& arguments, const PassSource& source,
                               const FrameControl& frame, RenderState& state, Report& report)
{
    RunControl control;
    control.progress = [&report, lines = frame.lines](const RunProgress& progress) {
        if (lines != nullptr)
            lines->progress(progress);
        std::string note =
            std::to_string(progress.passes) + (progress.passes == 1 ? " pass" : " passes");
        if (progress.error)
            note += ", error " + percent(progress.error->error);
        report.progress(progress.done, note);
    };
    control.stop = &frame.stop;
    if (frame.lines != nullptr)
        control.pass = [lines = frame.lines](const RenderState& now) { lines->pass(now); };
    std::uint64_t saved = count(state.film.passes);
    const auto save = [&](const RenderState& now) {
        // A state is written only for passes that it does not hold yet.
        if (arguments.files.state.empty() || count(now.film.passes) == saved)
            return;
        write_state(arguments.files.state, now);
        saved = count(now.film.passes);
    };
    control.save = save;
    report.begin("rendering " + std::to_string(source.width) + "x" + std::to_string(source.height) +
                 describe_stops(arguments.stops));
    RunResult out = run_passes(source, arguments.stops, control, state);
    report.end();
    save(state);
    return out;
}

/// Passes of the scene as it is, or of its moments while the shutter is open.
PassSource make_source(const PreparedFrame& frame, const RenderScene& scene, SceneSource& source,
                       RenderStatistics& statistics, PhotonCache* cache)
{
    const RenderOptions& options = frame.arguments.render;
    if (!frame.effects.has(Effect::motion_blur))
        return make_pass_source(scene, options, statistics, cache);
    const auto at = [&, shutter = shutter_time(frame.arguments)](double share) {
        return load_moment(frame, source, shutter.at(share));
    };
    return make_moving_source({scene, at}, options, statistics);
}

/// The photons that frames share; null: none, or none may be shared.
PhotonCache* find_cache(const PreparedFrame& frame, PreviousFrame* previous)
{
    if (previous == nullptr || frame.effects.has(Effect::motion_blur))
        return nullptr;
    return &cache_for(*previous, frame.loaded.scene, frame.partition, frame.sky,
                      frame.arguments.photon_cache_mib);
}

RenderedFrame render_passes(PreparedFrame& frame, SceneSource& source, PreviousFrame* previous,
                            const FrameControl& control, Report& report)
{
    PhotonCache* const cache = find_cache(frame, previous);
    RenderedFrame out;
    const Stopwatch building;
    const RenderScene scene(frame.loaded.scene, frame.partition, std::move(frame.sky));
    out.seconds_rays = building.seconds();
    const PassSource passes = make_source(frame, scene, source, out.statistics, cache);
    out.state = begin_or_resume(frame, passes, report);
    out.result = render_with_progress(frame.arguments, passes, control, out.state, report);
    if (cache != nullptr && cache->served > 0)
        report.line("only the camera moved: reused the photon maps of " +
                    std::to_string(cache->served) + " passes");
    return out;
}

} // namespace

RenderedFrame render_frame(PreparedFrame& frame, SceneSource& source, PreviousFrame* previous,
                           const FrameControl& control, Report& report)
{
    if (previous == nullptr)
        return render_passes(frame, source, previous, control, report);
    if (previous->rendered && previous->settings == frame.settings && !frame.found) {
        report.line("frame unchanged: reusing the previous image");
        if (!frame.arguments.files.state.empty())
            write_state(frame.arguments.files.state, previous->rendered->state);
        RenderedFrame out = *previous->rendered;
        out.seconds_rays = 0;
        return out;
    }
    RenderedFrame out = render_passes(frame, source, previous, control, report);
    previous->settings = frame.settings;
    previous->rendered.reset();
    if (!frame.found && out.result.reason != StopReason::caller)
        previous->rendered = out;
    return out;
}

} // namespace hipmap
