#include "preprocess/options.h"

#include "common/command_line/default_photons.h"
#include "common/command_line/scene_arguments.h"
#include "common/file/output_file.h"
#include "common/input_error.h"

#include <CLI/CLI.hpp>

#include <vector>

namespace hipmap {

namespace {

constexpr double kMostWeld = 1e9;

constexpr const char* kPartitionSection = "Partition";
constexpr const char* kCandidateSection = "Candidates for local and group maps";

std::vector<OptionRow> partition_rows(PreprocessArguments& arguments)
{
    return {{.name = "angle",
             .section = kPartitionSection,
             .field = number_field(arguments.angle_deg, {0, 180}, "DEG"),
             .help = "Angle threshold in degrees: neighbouring faces whose normals differ by less "
                     "share photons"},
            {.name = "split",
             .section = kPartitionSection,
             .field = choice_field<SplitBy>(arguments.split, kSplits, "WHAT"),
             .help = "What separates faces that share an edge: angle, normals (hard edges as "
                     "authored: split vertex normals) or both, whichever does"},
            {.name = "weld",
             .section = kPartitionSection,
             .field = number_field(arguments.weld_metres, {0, kMostWeld}, "M"),
             .help = "Merge vertices within this distance, in metres; 0: only vertices at the "
                     "same position"}};
}

std::vector<OptionRow> candidate_rows(PreprocessArguments& arguments)
{
    return {{.name = "photons",
             .section = kCandidateSection,
             .field = number_field(arguments.photons, {0, kMostPhotons}),
             .help = "Light paths of a pass of render for which candidates are chosen",
             .unset = "as many as render emits by default"},
            {.name = "neighbours",
             .section = kCandidateSection,
             .field = number_field(arguments.neighbours, {2, kMostNeighbours}),
             .help = "Photons in an estimate, k; a candidate is expected to hold 10 k"}};
}

std::vector<OptionRow> output_rows(PreprocessArguments& arguments)
{
    return {{.name = "output",
             .section = kFilesSection,
             .field = file_field(arguments.output, "FILE.hpm"),
             .help = "Partition file to write",
             .flags = "-o,--output",
             .required = true},
            {.name = "coloured",
             .section = kFilesSection,
             .field = file_field(arguments.coloured, "FILE.glb"),
             .help = "Write the scene in the colours of its shared maps, to open in Blender"},
            {.name = "images",
             .section = kFilesSection,
             .field = file_field(arguments.images, "DIR"),
             .help = "Folder for images of the partition: shared_maps.png and edges.png; created "
                     "if it is missing"},
            {.name = "candidates",
             .section = kFilesSection,
             .field = flag_field(arguments.candidates),
             .help = "Write candidates.png and groups.png to that folder as well: faces that "
                     "--maps thesis and hierarchical of render are expected to give maps of their "
                     "own",
             .needs = "images"},
            {.name = "size",
             .section = kFilesSection,
             .field = size_field(arguments.size),
             .help = "Size of these images in pixels, or percent of the default; W alone takes "
                     "the camera's aspect"},
            {.name = "json",
             .section = kFilesSection,
             .field = file_field(arguments.json),
             .help = "Write what was found as JSON"}};
}

} // namespace

std::vector<OptionRow> option_rows(PreprocessArguments& arguments)
{
    std::vector<OptionRow> rows = output_rows(arguments);
    append_rows(rows, partition_rows(arguments));
    append_rows(rows, candidate_rows(arguments));
    append_rows(rows, scene_rows(arguments.scene_options, arguments.sky));
    append_rows(rows, frame_rows(arguments.frames));
    rows.push_back(threads_row(arguments.threads));
    rows.push_back(texture_cache_row(arguments.scene_options.texture_cache_mib));
    rows.push_back(verbose_row(arguments.verbose));
    rows.push_back({.name = "quiet",
                    .section = kRunSection,
                    .field = flag_field(arguments.quiet),
                    .help = "Print the number of shared maps and defects of the mesh alone; render "
                            "prints what it finds in the scene"});
    return rows;
}

void add_arguments(CLI::App& app, PreprocessArguments& arguments)
{
    app.add_option("SCENE", arguments.scene, "Scene: .glb, .gltf or .obj")->required();
    add_options(app, option_rows(arguments));
}

PreprocessArguments arguments_of_frame(const PreprocessArguments& all, int frame)
{
    PreprocessArguments out = all;
    set_frame(out.scene_options, out.frames, frame);
    for (std::filesystem::path* file : {&out.output, &out.images, &out.json, &out.coloured})
        *file = frame_path(*file, frame);
    return out;
}

void check_outputs(const PreprocessArguments& arguments)
{
    const auto same_file = [](const std::filesystem::path& a, const std::filesystem::path& b) {
        std::error_code missing;
        return std::filesystem::equivalent(a, b, missing) ||
               std::filesystem::absolute(a).lexically_normal() ==
                   std::filesystem::absolute(b).lexically_normal();
    };
    std::vector<std::filesystem::path> used{arguments.scene};
    for (const std::filesystem::path& path :
         {arguments.output, arguments.json, arguments.coloured}) {
        if (path.empty())
            continue;
        for (const std::filesystem::path& other : used)
            if (same_file(path, other))
                throw InputError(path.string() + ": would overwrite " + other.string() +
                                 "; name another file");
        used.push_back(path);
        check_writable(path);
    }
    if (arguments.images.empty())
        return;
    check_writable(std::filesystem::is_directory(arguments.images)
                       ? arguments.images / "shared_maps.png"
                       : arguments.images);
    if (std::filesystem::exists(arguments.images) &&
        !std::filesystem::is_directory(arguments.images))
        throw InputError(arguments.images.string() + ": --images names a file, not a folder");
}

} // namespace hipmap
