#include "common/input_error.h"
#include "common/partition/check_partition.h"
#include "common/scene/load_scene.h"
#include "preprocess/partition/build_partition.h"

#include <catch2/catch.hpp>

#include <filesystem>
#include <set>

using namespace hipmap;

namespace {

/// Models that are no part of the repository; absent elsewhere.
const std::filesystem::path kScenes = std::filesystem::path(HIPMAP_SOURCE_DIR) / "../shared/scenes";

std::vector<std::filesystem::path> scene_files()
{
    std::vector<std::filesystem::path> files;
    const std::set<std::filesystem::path> suffixes{".glb", ".gltf", ".obj"};
    for (const char* folder : {"real", "blender"})
        if (std::filesystem::is_directory(kScenes / folder))
            for (const auto& entry :
                 std::filesystem::recursive_directory_iterator(kScenes / folder))
                if (suffixes.contains(entry.path().extension()))
                    files.push_back(entry.path());
    return files;
}

} // namespace

TEST_CASE("build_partition: real scenes give sound partitions", "[partition]")
{
    for (const std::filesystem::path& file : scene_files()) {
        INFO(file.string());
        if (file.string().find("gpu_instancing") != std::string::npos)
            continue; // millions of faces, which are for bench/partition_scale
        try {
            const LoadedScene loaded = load_scene(file, {});
            const PartitionResult result = build_partition(loaded.scene, {});
            CHECK(defect_of(result.partition) == "");
            CHECK(result.summary.defects.refused_faces == 0);
        } catch (const InputError& refused) { // what is not read yet is refused by name
            CHECK(std::string(refused.what()).find("not read") != std::string::npos);
        }
    }
}

TEST_CASE("build_partition: closed real models have no border after welding", "[partition]")
{
    for (const char* name : {"spot/spot.obj", "penguin/penguin.obj", "cad/wingnut.obj"}) {
        const std::filesystem::path file = kScenes / "real" / name;
        if (!std::filesystem::exists(file))
            continue;
        const PartitionResult result = build_partition(load_scene(file, {}).scene, {});
        CHECK(result.summary.defects.border_edges == 0);
        CHECK(result.summary.closed_faces == result.summary.faces);
    }
}
