// Compares the partitions of scenes with what the rules of docs/partition_file.md say when they are
// applied one by one to all pairs of vertices, edges and faces, and looks for border edges on
// closed objects.
//
//     partition_oracle SCENE|FOLDER...     exit code 1 if a partition is wrong
//
// A line says of a file: its faces, whether all of it is a closed manifold, how many objects are by
// themselves, the border edges and those of closed objects, and whether brute force agrees.

#include "bench/brute_force_partition.h"
#include "bench/edge_count.h"
#include "common/command_line/command_line.h"
#include "common/input_error.h"
#include "common/scene/load_scene.h"
#include "preprocess/partition/build_partition.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <numbers>

namespace {

using namespace hipmap;

struct OracleOptions {
    std::vector<std::filesystem::path> paths;
    double angle_deg = 30;
    std::size_t below = 5000; ///< faces: one scene takes a second here, and four at twice as many
};

struct Totals {
    std::size_t files = 0, refused = 0, closed = 0, compared = 0, wrong = 0;
};

/// Files themselves, and the scenes in folders and below, sorted.
std::vector<std::filesystem::path> find_scenes(const std::vector<std::filesystem::path>& paths)
{
    std::vector<std::filesystem::path> files;
    for (const std::filesystem::path& path : paths) {
        if (!std::filesystem::is_directory(path)) {
            files.push_back(path);
            continue;
        }
        for (const auto& entry : std::filesystem::recursive_directory_iterator(path)) {
            const std::filesystem::path suffix = entry.path().extension();
            if (suffix == ".glb" || suffix == ".gltf" || suffix == ".obj")
                files.push_back(entry.path());
        }
    }
    std::ranges::sort(files);
    return files;
}

/// Edges of objects that are closed manifolds by themselves but have no face beyond.
std::size_t open_edges_of_closed_objects(const TriangleMesh& mesh, const Partition& partition,
                                         const std::vector<EdgeCount>& objects)
{
    std::size_t open = 0;
    for (std::uint32_t edge = 0; edge < partition.edge_class.size(); ++edge)
        open += partition.edge_class[edge] == EdgeClass::border &&
                objects[mesh.object_of_face[edge / 3]].closed_manifold();
    return open;
}

void examine(const std::filesystem::path& file, const OracleOptions& options, Totals& totals)
{
    const Scene scene = load_scene(file, {}).scene;
    const PartitionResult result =
        build_partition(scene, {.angle_threshold = options.angle_deg * std::numbers::pi / 180});
    const bool closed = count_edges(scene.mesh, false)[0].closed_manifold();
    const std::vector<EdgeCount> objects = count_edges(scene.mesh, true);
    const auto closed_objects =
        static_cast<std::size_t>(std::ranges::count_if(objects, &EdgeCount::closed_manifold));
    const std::size_t open = open_edges_of_closed_objects(scene.mesh, result.partition, objects);
    const bool small = scene.mesh.face_count() < options.below;
    const std::string difference =
        small ? difference_from_brute_force(scene.mesh, result.partition) : "";
    totals.closed += closed;
    totals.compared += small;
    totals.wrong += !difference.empty() || open > 0;
    std::printf("%8zu  %-6s  %7zu  %8zu  %6zu  %-16s %s\n", scene.mesh.face_count(),
                closed ? "yes" : "no", closed_objects, result.summary.defects.border_edges, open,
                !small               ? "too many faces"
                : difference.empty() ? "yes"
                                     : ("no: " + difference).c_str(),
                file.c_str());
}

int partition_oracle(const OracleOptions& options)
{
    Totals totals;
    std::printf("%8s  %-6s  %7s  %8s  %6s  %-16s %s\n", "faces", "closed", "objects", "border",
                "open", "equal", "file");
    for (const std::filesystem::path& file : find_scenes(options.paths)) {
        ++totals.files;
        try {
            examine(file, options, totals);
        } catch (const InputError& error) {
            ++totals.refused;
            std::printf("%8s  %s\n", "-", error.what());
        }
        std::fflush(stdout);
    }
    std::printf("%zu files, %zu not scenes, %zu closed manifolds, %zu compared, %zu wrong\n",
                totals.files, totals.refused, totals.closed, totals.compared, totals.wrong);
    return totals.wrong > 0 ? kExitDefect : kExitDone;
}

} // namespace

int main(int argc, char** argv)
{
    return hipmap::run_tool([&] {
        OracleOptions options;
        CLI::App app("Compares partitions with brute force.", "partition_oracle");
        app.add_option("SCENE", options.paths, "Scenes, or folders of them")->required();
        app.add_option("--angle", options.angle_deg, "Angle threshold in degrees [30]")
            ->check(hipmap::finite_in(0, 180));
        app.add_option("--below", options.below, "Compare scenes of fewer faces [5000]");
        if (const std::optional<int> code = hipmap::parse_arguments(app, argc, argv))
            return *code;
        return partition_oracle(options);
    });
}
