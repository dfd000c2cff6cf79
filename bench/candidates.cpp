// How many of the local maps that `render --maps thesis` builds preprocess predicts, scene by
// scene.

#include "bench/predicted_maps.h"
#include "common/command_line/command_line.h"
#include "common/scene/load_scene.h"

#include <cmath>
#include <cstdio>
#include <filesystem>

namespace hipmap {

namespace {

struct Arguments {
    std::vector<std::string> scenes;
    std::uint64_t photons = 1'000'000;
    std::uint32_t neighbours = 50;
};

std::string share(std::size_t part, std::size_t whole)
{
    return whole == 0 ? ""
                      : std::to_string(std::lround(100.0 * double(part) / double(whole))) + " %";
}

void print_row(const std::string& name, const PredictedMaps& maps)
{
    std::printf("| %s | %zu | %zu | %zu | %s | %zu | %s | %zu | %s | %zu | %zu | %zu |\n",
                name.c_str(), maps.faces, maps.by_shape, maps.candidates,
                share(maps.used, maps.candidates).c_str(), maps.built,
                share(maps.foreseen, maps.built).c_str(), maps.able,
                share(maps.able_foreseen, maps.able).c_str(), maps.groups, maps.groups_used,
                maps.groups_full);
    std::fflush(stdout);
}

void print_table(const Arguments& arguments)
{
    std::puts("| scene | faces | candidates by shape | candidates | with a map | local maps built "
              "| on candidates | maps with searches | on candidates | groups predicted | of these "
              "full | groups full |\n|---|---|---|---|---|---|---|---|---|---|---|---|");
    PredictedMaps all;
    for (const std::string& path : arguments.scenes) {
        SceneOptions options;
        options.least_copied_faces = ~std::uint64_t{0};
        const LoadedScene loaded = load_scene(path, options);
        const PredictedMaps maps =
            compare_predicted_maps(loaded.scene, {arguments.photons, arguments.neighbours});
        print_row(std::filesystem::path(path).stem().string(), maps);
        all += maps;
    }
    print_row("all", all);
}

} // namespace

} // namespace hipmap

int main(int argc, char** argv)
{
    return hipmap::run_tool([&] {
        CLI::App app("Candidates for local maps beside the maps that --maps thesis builds, as a "
                     "Markdown table.",
                     "candidates");
        hipmap::Arguments arguments;
        app.add_option("SCENE", arguments.scenes, "Scenes: .glb, .gltf or .obj")->required();
        app.add_option("--photons", arguments.photons, "Light paths [1000000]")
            ->check(CLI::Range(1000, 100'000'000));
        app.add_option("--neighbours", arguments.neighbours, "k [50]")
            ->check(CLI::Range(2, 10'000));
        if (const std::optional<int> code = hipmap::parse_arguments(app, argc, argv))
            return *code;
        hipmap::print_table(arguments);
        return hipmap::kExitDone;
    });
}
