#include "render/run_frames.h"

#include "common/command_line/run_tool.h"
#include "common/scene/print_audit.h"
#include "common/scene/scene_names.h"
#include "render/describe_error.h"
#include "render/hide_fireflies.h"
#include "render/outputs.h"
#include "render/print_results.h"
#include "render/render_frame.h"
#include "render/run_plan.h"
#include "render/statistics.h"

#include <algorithm>
#include <csignal>
#include <iostream>

namespace hipmap {

namespace {

std::atomic<bool> g_stop{false};

extern "C" void ask_to_stop(int)
{
    g_stop = true;
}

/// place: among frames; null: there is a single one.
void print_preparation(const PreparedFrame& frame, FramePlace* place, Report& report)
{
    if (frame.arguments.frames.asked())
        report.detail("frame " + std::to_string(frame.arguments.frames.first));
    print_audit(report, frame.loaded.audit, place != nullptr ? &place->told : nullptr);
    report.detail("effects: " + list_effects(frame.effects) + " (--explain gives reasons)");
}

/// place: null where there is a single frame, whose error and files are printed.
void write_results(const PreparedFrame& frame, const RenderedFrame& rendered,
                   const FramePlace* place, Report& report)
{
    const RenderArguments& arguments = frame.arguments;
    print_statistics(arguments, rendered, report);
    if (place == nullptr || report.verbose())
        print_error(arguments, rendered, report);
    const WrittenFiles written =
        write_images(arguments.files, rendered.result.image, rendered.state, report);
    write_requested_layers(arguments, rendered, report);
    write_statistics(arguments.files, statistics_json(frame, rendered, written), report);
    if (place != nullptr && !report.verbose())
        report.take_files();
    report.list_files();
}

/// One line of a frame among others, and the total after the last.
void print_place(const RenderedFrame& rendered, FramePlace& place, Report& report)
{
    const std::uint64_t passes = count(rendered.state.film.passes);
    std::string line = place.text() + ": " + counted(passes, "pass", "passes");
    if (rendered.resumed > 0)
        line += " (" + std::to_string(rendered.resumed) + " of them resumed)";
    if (!rendered.state.checks.empty()) {
        const double error = rendered.state.checks.back().error.error;
        line += ", error " + percent(error);
        place.low = place.done == 0 ? error : std::min(place.low, error);
        place.high = std::max(place.high, error);
    }
    place.end_frame(passes > rendered.resumed);
    const std::optional<double> left = place.seconds_left(0);
    if (place.done < place.all && left)
        line += "; all frames " + brief_time(*left) + " left";
    report.line(line);
    if (place.done == place.all)
        report.line(
            "all " + std::to_string(place.all) + " frames: " + brief_time(place.watch.seconds()) +
            (place.high > 0 ? ", errors " + percent(place.low) + " to " + percent(place.high)
                            : ""));
}

/// What the frames of a run share.
struct FrameRun {
    SceneSource& source;
    PreviousFrame* previous = nullptr; ///< the previous frame, and this one afterwards; null: there
                                       ///< is none
    Ranks* ranks = nullptr;            ///< null: one process renders
};

/// Says how a render ended, and returns its exit code.
int end_of(const RenderedFrame& rendered, FramePlace* place, Report& report)
{
    if (rendered.result.reason == StopReason::caller) {
        const std::uint64_t passes = count(rendered.state.film.passes);
        report.line("stopped by a signal " +
                    (passes == 0
                         ? "in the first pass; the image is coarse where it was not rendered yet"
                         : "after " + counted(passes, "pass", "passes") + "; the image holds " +
                               (passes == 1 ? "it" : "them")));
        return kExitStopped;
    }
    if (place != nullptr)
        print_place(rendered, *place, report);
    return kExitDone;
}

int render(const RenderArguments& request, const FrameRun& run)
{
    Report report(request.verbose);
    limit_threads(request.threads);
    PreparedFrame frame;
    together(run.ranks, [&] { frame = prepare_frame(request, run.source); });
    if (request.explain) {
        print_audit(report, frame.loaded.audit);
        explain(frame.effects, report);
        return kExitDone;
    }
    FramePlace* const place = place_of(run.previous);
    print_preparation(frame, place, report);
    std::signal(SIGINT, ask_to_stop);
    std::signal(SIGTERM, ask_to_stop);
    std::optional<ProgressLines> lines;
    if (request.progress == ProgressFormat::json)
        lines.emplace(std::cout, frame.arguments);
    const FrameControl control = {g_stop, lines ? &*lines : nullptr, run.ranks};
    RenderedFrame rendered = render_frame(frame, run.source, run.previous, control, report);
    rendered.fireflies = hide_fireflies(frame.arguments.files.fireflies, rendered.state);
    if (rendered.fireflies.removed && rendered.fireflies.removed->pixels > 0)
        rendered.result.image = film_image(rendered.state.film);
    together(run.ranks, [&] {
        if (run.ranks == nullptr || run.ranks->leads())
            write_results(frame, rendered, place, report);
    });
    if (lines)
        lines->end(rendered.result, rendered.state);
    return end_of(rendered, place, report);
}

/// ranks: null: one process renders.
int render_all(const RenderArguments& arguments, PreviousFrame* kept, Ranks* ranks)
{
    std::optional<SceneSource> source;
    together(ranks, [&] {
        for_each_frame_of(arguments, [](const RenderArguments& one) {
            check_outputs(one.files);
            return kExitDone;
        });
        source.emplace(arguments.scene, arguments.scene_options);
    });
    const std::vector<std::filesystem::path>& images = arguments.files.images;
    if (arguments.frames.last > arguments.frames.first && !arguments.files.exposure_ev &&
        std::any_of(images.begin(), images.end(), is_exposed))
        Report().line("assumed: each frame gets its own exposure, so brightness may jump; "
                      "--exposure EV fixes it");
    PreviousFrame previous;
    previous.place.all = arguments.frames.last - arguments.frames.first + 1;
    PreviousFrame* const shared = place_of(&previous) != nullptr ? &previous : kept;
    return for_each_frame_of(arguments, [&](const RenderArguments& one) {
        return render(one, {*source, shared, ranks});
    });
}

/// The lead alone writes files and tells a program its progress.
void leave_to_lead(RenderArguments& arguments)
{
    arguments.files = {};
    arguments.progress = ProgressFormat::text;
}

} // namespace

int render_frames(const RenderArguments& arguments, PreviousFrame* kept)
{
    return render_all(arguments, kept, nullptr);
}

int render_in_ranks(RenderArguments arguments, Ranks& ranks)
{
    try {
        ranks.together([&] { complete_arguments(arguments); });
        Report(arguments.verbose)
            .detail(counted(static_cast<std::size_t>(ranks.count()), "process", "processes"));
        if (!ranks.leads())
            leave_to_lead(arguments);
        const int code = render_all(arguments, nullptr, &ranks);
        return ranks.leads() ? code : kExitDone;
    } catch (const std::exception& error) {
        ranks.abort(error.what());
        if (ranks.leads())
            throw;
        return kExitDone;
    }
}

} // namespace hipmap
