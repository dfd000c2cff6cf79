#pragma once

#include "common/input_error.h"
#include "common/scene/load_scene.h"
#include "preprocess/partition/build_partition.h"

#include <filesystem>

namespace hipmap {

/// Loads a scene that may be anything; one that loads must be partitioned soundly, too.
inline void load_and_partition(const std::filesystem::path& path)
{
    constexpr std::size_t kMostFaces = 5000; // keeps one try short
    try {
        const LoadedScene loaded = load_scene(path, {});
        if (loaded.scene.mesh.face_count() <= kMostFaces)
            build_partition(loaded.scene, {});
    } catch (const InputError&) {
        // What bad input is meant to end in.
    }
}

} // namespace hipmap
