// Renders a scene by a method that hipmap does not have, to be compared with its own.

#include "common/command_line/command_line.h"
#include "common/command_line/picture_size.h"
#include "common/image/exposure.h"
#include "common/image/write_image.h"
#include "common/scene/load_scene.h"
#include "experiments/rivals/methods.h"
#include "preprocess/partition/build_partition.h"
#include "render/effects/drop_effects.h"
#include "render/shading/part_touching_faces.h"

#include <nlohmann/json.hpp>

#include <cstdio>

namespace hipmap {

namespace {

struct Arguments {
    std::string scene, method, output, size = "256";
    RivalSettings settings;
    unsigned threads = 0;
};

void add_options(CLI::App& app, Arguments& arguments)
{
    std::string methods;
    for (const RivalMethod& method : rival_methods())
        methods += std::string("\n") + method.name + ": " + method.help;
    RivalSettings& settings = arguments.settings;
    app.add_option("SCENE", arguments.scene, "Scene to render")->required();
    app.add_option("--method", arguments.method, "Method:" + methods)->required();
    app.add_option("-o,--output", arguments.output, "Image to write")->required();
    app.add_option("--size", arguments.size, "Image size in pixels, WxH or W");
    app.add_option("--samples", settings.samples, "Eye paths of a pixel")
        ->check(CLI::Range(1, 65536));
    app.add_option("--seed", settings.seed, "Seed");
    app.add_option("--cells", settings.cells, "Cells of all faces, about");
    app.add_option("--rays", settings.rays, "Rays or light paths that carry light to the cells");
    app.add_option("--directions", settings.directions, "Rays of a cache record")
        ->check(CLI::Range(4, 65536));
    app.add_option("--tolerance", settings.tolerance, "Largest error of a cache record, a")
        ->check(finite_in(0.001, 10));
    app.add_option("--views", settings.views, "Cameras along each side of a light field")
        ->check(CLI::Range(2, 256));
    app.add_option("--window", settings.window, "Side of a light field's window, scene units")
        ->check(finite_in(0, 1));
    app.add_option("--threads", arguments.threads, "Threads; 0: all cores");
}

SceneOptions with_look(LookChoice look)
{
    SceneOptions out;
    out.look = look;
    return out;
}

/// Loads a scene as `render --look gltf` does, with the partition that preprocess makes by default.
struct Loaded {
    Scene scene;
    Partition partition;

    explicit Loaded(const std::string& path)
        : scene(load_scene(path, with_look(LookChoice::gltf)).scene),
          partition(build_partition(scene, {}).partition)
    {
        part_touching_faces(scene, partition);
        drop_effects(scene, plan_effects(scene, partition, {}));
    }
};

void render(const Arguments& arguments)
{
    const RivalMethod& method = rival_method(arguments.method.c_str());
    const Loaded loaded(arguments.scene);
    const RenderScene scene(loaded.scene, loaded.partition);
    RivalSettings settings = arguments.settings;
    const Camera& camera = loaded.scene.cameras[loaded.scene.camera];
    const PictureSize size = complete_size(parse_picture_size(arguments.size, {}), camera.aspect);
    settings.width = size.width;
    settings.height = size.height;
    RivalImage out = method.render(scene, settings);
    write_image(arguments.output, out.image, {.exposure_ev = auto_exposure(out.image)});
    const nlohmann::json json{{"prepared_s", out.prepared.processor},
                              {"rendered_s", out.rendered.processor},
                              {"stored_bytes", out.stored}};
    std::printf("%s\n", json.dump().c_str());
}

} // namespace

} // namespace hipmap

int main(int argc, char** argv)
{
    return hipmap::run_tool([&] {
        CLI::App app("Renders a scene by a method to compare hipmap with.", "rivals");
        hipmap::Arguments arguments;
        hipmap::add_options(app, arguments);
        if (const std::optional<int> code = hipmap::parse_arguments(app, argc, argv))
            return *code;
        hipmap::limit_threads(arguments.threads);
        hipmap::render(arguments);
        return hipmap::kExitDone;
    });
}
