#pragma once

#include "common/input_error.h"
#include "common/partition/check_partition.h"
#include "common/partition/expand_copies.h"
#include "common/partition/partition_file.h"
#include "common/scene/load_scene.h"
#include "preprocess/partition/previous_frame.h"

#include <array>
#include <cstdlib>
#include <filesystem>
#include <optional>

namespace hipmap {

inline constexpr std::size_t kMostFaces = 5000; ///< keeps one try short

/// Loads a scene with as many copies as it can have; its partition must be sound, also with all of
/// them stored.
inline void partition_with_copies(const std::filesystem::path& path)
{
    SceneOptions options;
    options.least_copied_faces = 1;
    Scene scene = load_scene(path, options).scene;
    if (scene.mesh.copies.empty() || scene.mesh.all_face_count() > kMostFaces)
        return;
    const Partition copied = build_partition_of_copies(scene, {}).partition;
    if (!defect_of(copied).empty() || !defect_of(expand_copies(copied, scene.mesh)).empty())
        std::abort();
}

/// Loads a scene that may be anything as it stands and at two moments of its animation; what loads
/// must be partitioned soundly, and as if it were alone.
inline void load_and_partition(const std::filesystem::path& path)
{
    try {
        partition_with_copies(path);
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
