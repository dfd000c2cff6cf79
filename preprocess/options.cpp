#include "preprocess/options.h"

#include "common/command_line/scene_arguments.h"
#include "common/file/output_file.h"
#include "common/input_error.h"

#include <map>
#include <vector>

namespace hipmap {

namespace {

const std::map<std::string, SplitBy> kSplits{
    {"angle", SplitBy::angle}, {"normals", SplitBy::normals}, {"both", SplitBy::both}};

} // namespace

void add_preprocess_arguments(CLI::App& app, PreprocessArguments& arguments)
{
    app.add_option("SCENE", arguments.scene, "Scene: .glb, .gltf or .obj")->required();
    app.add_option("-o,--output", arguments.output, "Partition file to write")
        ->required()
        ->type_name("FILE.hpm");
    app.add_option("--angle", arguments.angle_deg,
                   "Angle threshold in degrees: neighbouring faces whose normals differ by less "
                   "share photons [30]")
        ->check(finite_in(0, 180))
        ->type_name("DEG");
    app.add_option_function<std::string>(
           "--split", [&arguments](const std::string& name) { arguments.split = kSplits.at(name); },
           "What parts faces that share an edge: angle, normals (the author's hard edges: split "
           "vertex normals) or both, whichever does [angle]")
        ->check(CLI::IsMember(kSplits))
        ->type_name("WHAT");
    app.add_option("--weld", arguments.weld_metres,
                   "Take vertices no farther apart than this, in metres, for one [0: only those at "
                   "the very same place]")
        ->check(finite_in(0, 1e9))
        ->type_name("M");
    app.add_option("--coloured", arguments.coloured,
                   "Write the faces with the colours of their shared maps as a model to turn about")
        ->type_name("FILE.glb");
    app.add_option("--images", arguments.images,
                   "Folder for three pictures of the partition: shared_maps.png, edges.png, "
                   "candidates.png; made if it is missing")
        ->type_name("DIR");
    app.add_option("--json", arguments.json, "Write what was found as JSON")->type_name("FILE");
    app.add_option_function<std::string>(
           "--size",
           [&arguments](const std::string& text) { arguments.size = parse_picture_size(text); },
           "Size of the pictures in pixels; W alone takes the camera's aspect [768]")
        ->type_name("WxH");
    app.add_option("--threads", arguments.threads, "Threads; 0: all cores [0]")
        ->check(finite_in(0, 4096))
        ->type_name("N");
    add_scene_arguments(app, arguments.scene_options, arguments.sky);
    add_frame_arguments(app, arguments.frames);
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
                throw InputError(path.string() + ": would be written over " + other.string() +
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
