// What it costs to rebuild one shared map alone, beside all maps, by tree.

#include "common/command_line/command_line.h"
#include "common/input_error.h"
#include "common/scene/load_scene.h"
#include "preprocess/partition/build_partition.h"
#include "render/dissertation/dissertation.h"
#include "render/photons/trace_photons.h"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <numbers>

namespace hipmap {

namespace {

/// As many photons take some milliseconds.
constexpr std::size_t kLasting = 100'000;

struct Arguments {
    std::string scene;
    std::uint64_t paths = 500'000;
    std::uint32_t neighbours = 50;
    double angle_deg = 90; ///< the dissertation's
    int rounds = 9;
};

struct Tree {
    const char* name;
    TreeKind kind;
};

constexpr Tree kTrees[] = {{"balanced", TreeKind::balanced},
                           {"unbalanced", TreeKind::unbalanced},
                           {"midpoint", TreeKind::midpoint},
                           {"wide", TreeKind::wide}};

/// The photons of each map that has some, most first.
std::vector<std::vector<Photon>> photons_by_map(const std::vector<Photon>& photons,
                                                const Partition& partition)
{
    std::vector<std::vector<Photon>> out(partition.map_count);
    for (const Photon& photon : photons)
        out[partition.map_of_face[photon.face]].push_back(photon);
    std::sort(out.begin(), out.end(),
              [](const auto& a, const auto& b) { return a.size() > b.size(); });
    while (!out.empty() && out.back().empty())
        out.pop_back();
    return out;
}

/// Processor milliseconds to build the maps of some photons, once or as often as makes it last.
double build_ms(const std::vector<Photon>& photons, const MapSurfaces& surfaces,
                std::uint32_t neighbours, TreeKind kind)
{
    DissertationOptions options;
    options.estimate = EstimateForm::thesis;
    options.tree = kind;
    const std::size_t times = std::clamp<std::size_t>(kLasting / photons.size(), 1, 1000);
    std::size_t bytes = 0;
    const std::clock_t start = std::clock();
    for (std::size_t i = 0; i < times; ++i)
        bytes += bytes_of(build_chosen_maps(photons, surfaces, {neighbours}, options));
    const double ms = 1e3 * double(std::clock() - start) / CLOCKS_PER_SEC;
    return bytes > 0 ? ms / double(times) : 0;
}

/// Prints a row for each round and tree; in turn, so that what else the machine does falls on all
/// alike.
void measure(const Arguments& arguments)
{
    SceneOptions as_gltf;
    as_gltf.look = LookChoice::gltf; // as in docs/experiments.md
    const LoadedScene loaded = load_scene(arguments.scene, as_gltf);
    const double angle = arguments.angle_deg * std::numbers::pi / 180;
    const Partition partition = build_partition(loaded.scene, {.angle_threshold = angle}).partition;
    const RenderScene scene(loaded.scene, partition);
    const MapSurfaces surfaces(loaded.scene.mesh, partition);
    const std::vector<Photon> photons =
        trace_photons(scene, {.paths = arguments.paths, .store_direct = true, .caustic_paths = 0})
            .global;
    const std::vector<std::vector<Photon>> maps = photons_by_map(photons, partition);
    if (maps.empty())
        throw InputError(arguments.scene + ": no photon is stored; add a light");
    std::printf("tree;maps;photons;largest;median;ms all;ms largest;ms median\n");
    const std::vector<Photon>&largest = maps.front(), &median = maps[maps.size() / 2];
    for (const Tree& tree : kTrees) // the first build of a process takes longer
        build_ms(photons, surfaces, arguments.neighbours, tree.kind);
    for (int round = 0; round < arguments.rounds; ++round)
        for (const Tree& tree : kTrees) {
            const auto ms = [&](const std::vector<Photon>& some) {
                return build_ms(some, surfaces, arguments.neighbours, tree.kind);
            };
            std::printf("%s;%zu;%zu;%zu;%zu;%.4f;%.4f;%.4f\n", tree.name, maps.size(),
                        photons.size(), largest.size(), median.size(), ms(photons), ms(largest),
                        ms(median));
        }
}

} // namespace

} // namespace hipmap

int main(int argc, char** argv)
{
    return hipmap::run_tool([&] {
        CLI::App app(
            "What it costs to rebuild the largest shared map and the median one alone, beside "
            "all maps: processor ms by round and tree, separated by ;",
            "rebuild_maps");
        hipmap::Arguments arguments;
        app.add_option("SCENE", arguments.scene, "Scene: .glb, .gltf or .obj")->required();
        app.add_option("--photons", arguments.paths, "Light paths [500000]")
            ->check(CLI::Range(1000, 100'000'000));
        app.add_option("--neighbours", arguments.neighbours, "k [50]")
            ->check(CLI::Range(2, 10'000));
        app.add_option("--angle", arguments.angle_deg, "Angle threshold, degrees [90]")
            ->check(CLI::Range(0, 180));
        app.add_option("--rounds", arguments.rounds, "Times to build each [9]")
            ->check(CLI::Range(1, 1000));
        if (const std::optional<int> code = hipmap::parse_arguments(app, argc, argv))
            return *code;
        hipmap::measure(arguments);
        return hipmap::kExitDone;
    });
}
