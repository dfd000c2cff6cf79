#pragma once

#include "common/input_error.h"
#include "common/partition/partition_file.h"
#include "common/scene/load_scene.h"
#include "preprocess/partition/previous_frame.h"

#include <array>
#include <cstdlib>
#include <filesystem>
#include <optional>

namespace hipmap {

/// Loads a scene that may be anything as it stands and at two moments of its animation; what loads
/// must be partitioned soundly, and as if it were alone.
inline void load_and_partition(const std::filesystem::path& path)
{
    constexpr std::size_t kMostFaces = 5000; // keeps one try short
    try {
        SceneSource source(path, {});
        std::optional<PreviousFrame> frame;
        const std::array<std::optional<double>, 3> times{std::nullopt, 0.25, 0.5};
        for (const std::optional<double>& time : times) {
            const LoadedScene loaded = source.at(time);
            if (loaded.scene.mesh.face_count() > kMostFaces)
                return;
            build_partition(loaded.scene, {}, frame);
            const Partition alone = build_partition(loaded.scene, {}).partition;
            if (partition_checksum(alone) != partition_checksum(frame->result.partition))
                std::abort();
        }
    } catch (const InputError&) {
        // What bad input is meant to end in.
    }
}

} // namespace hipmap
