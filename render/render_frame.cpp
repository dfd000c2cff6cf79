#include "render/render_frame.h"

#include "common/scene/scene_names.h"
#include "common/stopwatch.h"
#include "render/describe_error.h"
#include "render/frame_source.h"
#include "render/layers/surface_layers.h"
#include "render/live_images.h"
#include "render/many/run_ranks.h"
#include "render/quote.h"
#include "render/seen_objects.h"
#include "render/unreachable_lights.h"

namespace hipmap {

namespace {

/// What a person calls the image: "room.glb, frame 3"; '?' for what is not printable ASCII.
std::string label_of(const RenderArguments& arguments)
{
    std::string out = arguments.scene.filename().string();
    std::ranges::replace_if(
        out, [](char c) { return c < ' ' || c > '~'; }, '?');
    if (arguments.frames.asked())
        out += ", frame " + std::to_string(arguments.frames.first);
    return out;
}

/// Takes the state that was found, if there is one.  stopped: no pass will be added, and pilots may
/// not have said what the state must be of.
RenderState begin_or_resume(PreparedFrame& frame, const PassSource& source, bool stopped)
{
    const std::string label = label_of(frame.arguments);
    if (frame.found) {
        RenderState state =
            stopped ? std::move(*frame.found)
                    : resume_state(source, std::move(*frame.found), frame.arguments.files.state);
        state.label = std::min(label, state.label);
        return state;
    }
    RenderState state = begin_state(source, frame.settings);
    state.image = frame.arguments.tiled;
    state.label = label;
    return state;
}

/// place: among frames, whose lines say it; null: there is a single one.
void print_resuming(const PreparedFrame& frame, const FramePlace* place, Report& report)
{
    if (!frame.found)
        return;
    const std::string text = "resuming with " +
                             counted(count(frame.found->film.passes), "pass", "passes") + " from " +
                             frame.arguments.files.state.string();
    if (place != nullptr)
        report.detail(text);
    else
        report.line(text);
}

std::string describe_pixels(const RenderOptions& options)
{
    const PixelRect pixels = rendered_pixels(options);
    const std::string size = std::to_string(pixels.width()) + "x" + std::to_string(pixels.height());
    const ImagePlace place = rendered_place(options);
    if (place.whole_width == 0)
        return size;
    return size + " pixels at " + std::to_string(place.x) + "," + std::to_string(place.y) + " of " +
           std::to_string(place.whole_width) + "x" + std::to_string(place.whole_height);
}

std::string describe_stops(const StopRules& stops)
{
    std::string text;
    if (stops.passes < kMostPasses)
        text += ", " + counted(stops.passes, "pass", "passes");
    if (std::isfinite(stops.seconds))
        text += ", at most " + brief_time(stops.seconds);
    if (stops.error > 0)
        text += ", until the error is " + percent(stops.error);
    return text;
}

std::string describe_progress(const RunProgress& progress, const FramePlace* place)
{
    std::string note =
        progress.passes > 0 ? counted(progress.passes, "pass", "passes") : "first pass";
    if (progress.error)
        note += ", error " + percent(progress.error->error);
    if (place == nullptr)
        return note;
    if (const std::optional<double> left = place->seconds_left(progress.done.value_or(0)))
        note += ", all frames " + brief_time(*left) + " left";
    return note;
}

/// ranks: null: one process.
PilotTeam team_of(Ranks* ranks)
{
    if (ranks == nullptr)
        return {};
    return {static_cast<std::size_t>(ranks->rank()), static_cast<std::size_t>(ranks->count()),
            [ranks](std::span<const std::byte> own, std::size_t element) {
                return ranks->join(own, element);
            }};
}

/// Shows the coarse image of a render that has no passes yet, and keeps it.
PilotControl pilot_control(const FrameControl& control, bool begins, CoarseImage& kept,
                           LiveImages& images, Report& report)
{
    PilotControl out{&control.stop, {}, team_of(control.ranks)};
    if (!begins || (control.ranks != nullptr && !control.ranks->leads()))
        return out;
    out.coarse = [&, lines = control.lines](const CoarseImage& coarse) {
        if (control.stop) // in the middle of it
            return;
        kept = coarse;
        const std::vector<std::filesystem::path> written = images.show(coarse);
        if (lines != nullptr && !written.empty())
            lines->coarse(written);
        report.progress({}, "preparing");
    };
    return out;
}

/// place: among frames; null: there is a single one.  images: rewritten after passes.
RunControl make_control(const FramePlace* place, const FrameControl& frame, LiveImages& images,
                        Report& report)
{
    RunControl control;
    control.progress = [&report, place, lines = frame.lines](const RunProgress& progress) {
        if (lines != nullptr)
            lines->progress(progress);
        report.progress(progress.done, describe_progress(progress, place), progress.left);
    };
    control.stop = &frame.stop;
    control.pass = [&images, lines = frame.lines](RenderState& now) {
        const std::vector<std::filesystem::path> rewritten = images.rewrite(now);
        if (lines != nullptr)
            lines->pass(now, rewritten);
    };
    return control;
}

/// ranks: null: one process.
RunResult run_and_save(const RenderArguments& arguments, const PassSource& source,
                       RunControl control, RenderState& state, Ranks* ranks)
{
    std::uint64_t saved = count(state.film.passes);
    Spent writing, showing;
    control.pass = [&showing, show = std::move(control.pass)](RenderState& now) {
        const Stopwatch watch;
        show(now);
        showing.add(watch);
    };
    control.save = [&](const RenderState& now) {
        // A state is written only for passes that it does not hold yet.
        if (arguments.files.state.empty() || count(now.film.passes) == saved)
            return;
        const Stopwatch watch;
        write_state(arguments.files.state, now);
        writing.add(watch);
        saved = count(now.film.passes);
    };
    StopRules stops = arguments.stops;
    stops.fireflies = arguments.files.fireflies;
    RunResult out = ranks != nullptr ? run_ranks(source, stops, control, state, *ranks)
                                     : run_passes(source, stops, control, state);
    together(ranks, [&] { control.save(state); });
    out.costs.state = writing;
    out.costs.previews = showing;
    return out;
}

bool shows_nothing(const Image& image)
{
    return std::ranges::all_of(image.pixels, [](const Rgb& pixel) { return is_black(pixel); });
}

/// Finds light that was missed, and what a black image looks at.
void look_at_image(const RenderScene& scene, const RenderOptions& options, RenderedFrame& frame)
{
    frame.missed =
        find_missed_light(frame.statistics, options.filter, frame.state.film.pixel_count());
    if (frame.missed.unseen)
        frame.unseen = describe_light(scene, frame.missed.unseen->light);
    if (!frame.result.image.pixels.empty() && shows_nothing(frame.result.image))
        frame.seen = describe_seen(scene, options);
}

/// The layers of surfaces; none if no file of layers is requested.
std::vector<LayerImage> requested_surfaces(const RenderScene& scene,
                                           const RenderArguments& arguments)
{
    if (arguments.files.layers.empty())
        return {};
    return surface_layers(scene, arguments.render, chosen_layers(arguments.layers));
}

/// The photons that frames share; null: none, or none may be shared.
PhotonCache* find_cache(const PreparedFrame& frame, PreviousFrame* previous)
{
    if (previous == nullptr || frame.effects.has(Effect::motion_blur))
        return nullptr;
    return &cache_for(*previous, frame.loaded.scene, frame.partition, frame.sky,
                      frame.arguments.photon_cache_mib);
}

/// place: among frames; null: there is a single one.
void begin_report(const PreparedFrame& frame, const FramePlace* place, Report& report)
{
    print_resuming(frame, place, report);
    report.begin((place != nullptr ? place->text() + ", " : "rendering ") +
                 describe_pixels(frame.arguments.render) + describe_stops(frame.arguments.stops));
}

/// cache: null: none.
void end_report(const FramePlace* place, const PhotonCache* cache, Report& report)
{
    if (place != nullptr)
        report.end_quietly();
    else
        report.end();
    if (cache != nullptr && cache->served > 0)
        report.detail("only the camera moved: reused the photon maps of " +
                      std::to_string(cache->served) + " passes");
    if (cache != nullptr && cache->taken_over > 0)
        report.detail("kept " + std::to_string(cache->taken_over) + " of " +
                      std::to_string(cache->taken_over + cache->built) +
                      " photon maps, whose photons are those of the previous frame");
}

RenderedFrame render_passes(PreparedFrame& frame, SceneSource& source, PreviousFrame* previous,
                            const FrameControl& control, Report& report)
{
    PhotonCache* const cache = find_cache(frame, previous);
    RenderedFrame out;
    const Stopwatch building;
    const RenderScene scene(frame.loaded.scene, frame.partition, std::move(frame.sky));
    out.rays.add(building);
    const FramePasses own = {frame, source, frame.effects, frame.arguments.render};
    const FramePlace* const place = place_of(previous);
    begin_report(frame, place, report);
    const auto surfaces = [&]() -> const std::vector<LayerImage>& {
        if (out.layers.empty())
            out.layers = requested_surfaces(scene, frame.arguments);
        return out.layers;
    };
    LiveImages images(frame.arguments, surfaces);
    CoarseImage coarse;
    const PilotControl pilots = pilot_control(control, !frame.found, coarse, images, report);
    const Stopwatch piloting;
    const PassSource passes = make_frame_source(own, scene, out.statistics, cache, pilots);
    if (stopped_together(pilots)) // then pilots ended early in all processes
        control.stop = true;
    out.pilots.add(piloting);
    out.state = begin_or_resume(frame, passes, control.stop);
    out.resumed = count(out.state.film.passes);
    out.result = run_and_save(frame.arguments, passes, make_control(place, control, images, report),
                              out.state, control.ranks);
    if (!out.result.kept.empty() && !coarse.image.pixels.empty())
        fill_by_coarse(coarse, out.result.kept, out.result.image);
    surfaces();
    out.unreachable = unreachable_lights(scene, frame.effects);
    look_at_image(scene, frame.arguments.render, out);
    if (frame.arguments.quote && control.ranks == nullptr)
        out.quote = make_quote({own, scene, out}, control.stop);
    end_report(place, cache, report);
    return out;
}

/// The lead decides for all ranks: it alone reads states.
bool is_unchanged(const PreparedFrame& frame, const PreviousFrame& previous, Ranks* ranks)
{
    const bool out = previous.rendered && previous.settings == frame.settings && !frame.found;
    return ranks != nullptr ? ranks->from_lead(out ? 1 : 0) != 0 : out;
}

} // namespace

RenderedFrame render_frame(PreparedFrame& frame, SceneSource& source, PreviousFrame* previous,
                           const FrameControl& control, Report& report)
{
    if (previous == nullptr)
        return render_passes(frame, source, previous, control, report);
    if (is_unchanged(frame, *previous, control.ranks)) {
        report.detail("frame unchanged: reusing the previous image");
        RenderedFrame out = *previous->rendered;
        out.state.label = label_of(frame.arguments);
        together(control.ranks, [&] {
            if (!frame.arguments.files.state.empty())
                write_state(frame.arguments.files.state, out.state);
        });
        out.resumed = count(out.state.film.passes);
        out.rays = {};
        out.pilots = {};
        out.result.costs = {};
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
