#include "preprocess/options.h"

#include "common/command_line/scene_arguments.h"
#include "common/file/output_file.h"
#include "common/input_error.h"

#include <vector>

namespace hipmap {

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
    add_scene_arguments(app, arguments.scene_options);
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
    for (const std::filesystem::path& path : {arguments.output, arguments.json}) {
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
