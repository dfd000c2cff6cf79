#include "common/command_line/command_line.h"
#include "common/file/output_file.h"
#include "common/partition/expand_copies.h"
#include "common/partition/partition_file.h"
#include "common/report.h"
#include "common/scene/print_audit.h"
#include "common/scene/store_copies.h"
#include "common/stopwatch.h"
#include "preprocess/choose_candidates.h"
#include "preprocess/colouring/coloured_glb.h"
#include "preprocess/colouring/partition_pictures.h"
#include "preprocess/open_glass.h"
#include "preprocess/partition/previous_frame.h"
#include "preprocess/summary.h"

#include <numbers>
#include <set>

namespace hipmap {

namespace {

const char* const kMemoryAdvice =
    "export fewer faces or instances, leave out --images and --coloured, or use fewer --threads";

/// Returns whether a sentence is to be printed: one that no frame has printed, or a verbose report
/// gets it.  Adds it to `told`.
bool is_news(const std::string& sentence, std::set<std::string>& told, const Report& report)
{
    return told.insert(sentence).second || report.verbose();
}

/// told: what earlier frames printed.
void print_summary(const PartitionSummary& summary, const PreprocessArguments& arguments,
                   std::set<std::string>& told, Report& report)
{
    if (report.verbose()) {
        for (const std::string& sentence : describe(summary, arguments.angle_deg))
            report.line(sentence);
    } else {
        if (const std::string maps = describe_maps(summary); is_news(maps, told, report))
            report.line("partition: " + maps);
        const std::string candidates = describe_candidates(summary);
        if (!arguments.quiet && is_news(candidates, told, report))
            report.line(candidates);
    }
    for (const std::string& sentence : describe_defects(summary))
        if (is_news(sentence, told, report))
            report.warn(sentence);
}

/// Makes the partition of a scene, reusing the previous frame's if there is one.
void make_partition(const PreprocessArguments& arguments, Scene& scene,
                    std::optional<PreviousFrame>& frame, Report& report)
{
    const PartitionOptions options{.angle_threshold = arguments.angle_deg * std::numbers::pi / 180,
                                   .split = arguments.split,
                                   .weld_distance =
                                       arguments.weld_metres / scene.frame.metres_per_unit};
    if (!scene.mesh.copies.empty()) { // which no animation has
        frame.emplace();
        frame->result = build_partition_of_copies(scene, options);
        return;
    }
    if (frame && frame->result.partition.scene == fingerprint(scene)) {
        report.detail("frame unchanged: reusing the previous partition");
        frame->result.summary.passes.clear();
        return;
    }
    build_partition(scene, options, frame);
    if (!arguments.frames.asked()) { // nobody asks for the rest
        PreviousFrame needed;
        needed.tree = std::move(frame->tree);
        needed.result = std::move(frame->result);
        *frame = std::move(needed);
    }
}

/// Paints the images asked for, if any, and adds the time to the summary.
std::vector<LegendedPicture> paint_pictures(const PreprocessArguments& arguments,
                                            const PartitionView& shown, PartitionSummary& summary,
                                            Report& report)
{
    if (arguments.images.empty())
        return {};
    const Stopwatch painting;
    const auto size = complete_size(arguments.size, shown.scene.cameras[shown.scene.camera].aspect);
    std::vector<LegendedPicture> pictures =
        write_partition_pictures(arguments.images, shown, size.width, size.height);
    for (const LegendedPicture& picture : pictures)
        report.wrote(picture.path);
    summary.passes.push_back({"paint images", painting.seconds()});
    return pictures;
}

/// Writes the pictures and the coloured model asked for, if any.
std::vector<LegendedPicture> show_stored(const PreprocessArguments& arguments,
                                         const PartitionView& shown, PartitionSummary& summary,
                                         Report& report)
{
    std::vector<LegendedPicture> pictures = paint_pictures(arguments, shown, summary, report);
    if (!arguments.coloured.empty()) {
        const Stopwatch writing;
        write_coloured_glb(arguments.coloured, shown.scene, shown.partition);
        report.wrote(arguments.coloured);
        summary.passes.push_back({"write coloured model", writing.seconds()});
    }
    return pictures;
}

/// Writes what shows every face, for which all copies are stored.  photons: predicted by stored
/// face; none: not predicted.
std::vector<LegendedPicture> show_partition(const PreprocessArguments& arguments,
                                            const Scene& scene, std::span<const float> photons,
                                            PartitionResult& result, Report& report)
{
    if (scene.mesh.copies.empty() || (arguments.images.empty() && arguments.coloured.empty()))
        return show_stored(arguments, {scene, result.partition, arguments.candidates, photons},
                           result.summary, report);
    Scene stored = scene;
    const Partition partition = expand_copies(result.partition, scene.mesh);
    std::vector<float> of_all(photons.empty() ? 0 : partition.face_count());
    for (std::size_t face = 0; face < of_all.size(); ++face)
        of_all[face] = photons[scene.mesh.stored_face(static_cast<FaceId>(face))];
    store_copies(stored.mesh);
    return show_stored(arguments, {stored, partition, arguments.candidates, of_all}, result.summary,
                       report);
}

/// What frames of an animation hand on.
struct Frames {
    std::optional<PreviousFrame> previous;
    std::set<std::string> told; ///< sentences of the audit
};

void print_files(const PreprocessArguments& arguments, Report& report)
{
    if (arguments.quiet)
        report.take_files();
    report.list_files();
}

int preprocess(const PreprocessArguments& arguments, SceneSource& source, Frames& frames)
{
    std::optional<PreviousFrame>& frame = frames.previous;
    Report report(arguments.verbose);
    limit_threads(arguments.threads);

    const Stopwatch loading;
    LoadedScene loaded = source.at(arguments.scene_options.time, !arguments.frames.asked());
    if (arguments.frames.asked() && !arguments.quiet)
        report.line("frame " + std::to_string(arguments.frames.first));
    if (!arguments.quiet)
        print_audit(report, loaded.audit, &frames.told);
    const double load_seconds = loading.seconds();

    Scene& scene = loaded.scene;
    make_partition(arguments, scene, frame, report);
    PartitionResult& result = frame->result;
    result.summary.passes.insert(result.summary.passes.begin(), {"load scene", load_seconds});
    const Candidates by_shape =
        arguments.frames.asked() ? candidates_of(result.partition) : Candidates();
    const std::vector<float> photons = choose_candidates(arguments, scene, frame->tree, result);
    print_summary(result.summary, arguments, frames.told, report);
    for (const std::string& sentence : describe_open_glass(scene, result.partition))
        if (is_news(sentence, frames.told, report))
            report.line("assumed: " + sentence);
    const Stopwatch writing;
    write_partition(arguments.output, result.partition);
    result.summary.passes.push_back({"write partition", writing.seconds()});
    report.wrote(arguments.output);
    const std::vector<LegendedPicture> pictures =
        show_partition(arguments, scene, photons, result, report);
    if (!arguments.json.empty()) {
        write_file(arguments.json,
                   summary_json(arguments, scene, result.partition, result.summary, pictures));
        report.wrote(arguments.json);
    }
    print_files(arguments, report);
    if (arguments.frames.asked()) // the next frame expects those
        set_candidates(by_shape, result.partition);
    return kExitDone;
}

int preprocess_frames(const PreprocessArguments& arguments)
{
    for_each_frame_of(arguments, [](const PreprocessArguments& one) {
        check_outputs(one);
        return kExitDone;
    });
    SceneSource source(arguments.scene, arguments.scene_options);
    Frames frames;
    return for_each_frame_of(
        arguments, [&](const PreprocessArguments& one) { return preprocess(one, source, frames); });
}

} // namespace

} // namespace hipmap

int main(int argc, char** argv)
{
    return hipmap::run_tool(hipmap::kMemoryAdvice, [&] {
        hipmap::PreprocessArguments arguments;
        CLI::App app("Decides which faces of a scene may share photons.",
                     hipmap::started_as(argv[0]));
        app.set_version_flag("--version", "preprocess " HIPMAP_VERSION);
        hipmap::add_arguments(app, arguments);
        if (const std::optional<int> code = hipmap::parse_arguments(app, argc, argv))
            return *code;
        arguments.command = hipmap::command_of("preprocess", argc, argv);
        return hipmap::preprocess_frames(arguments);
    });
}
