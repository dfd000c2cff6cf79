#pragma once

#include "common/scene/gltf_animation.h"
#include "common/scene/gltf_document.h"
#include "common/scene/raw_scene.h"

#include <tiny_gltf.h>

#include <filesystem>
#include <optional>

namespace hipmap {

/// A .gltf or .glb file that is read once and returns the default scene, with all instances, at any
/// time.  Faces come in the order of a depth-first walk, so one file gives the same faces at any
/// time.  Not for several threads at once.
class GltfSource {
  public:
    /// Reads the file.  options: their look and the units of its lights.  Throws InputError with
    /// the place and what is wrong.
    GltfSource(const std::filesystem::path& path, const SceneOptions& options);

    /// Returns the scene at `time` of the animation, in seconds; none: the nodes as they stand in
    /// the file.  last: no other time will be asked for, so textures need not be copied.  Throws
    /// InputError with the place and what is wrong.
    RawScene at(std::optional<double> time, bool last);

  private:
    GltfDocument document_;
    tinygltf::Model model_;
    std::vector<tinygltf::Node> rest_; ///< the model's nodes as in the file
    RawScene timeless_;                ///< materials, textures and what the audit says of them
    GltfAnimation animation_;
    std::optional<SceneSweep> sweep_;
    bool swept_ = false;
    std::uint64_t least_copied_ = 0; ///< faces
    bool by_blender_ = false;        ///< Blender's exporter wrote the file
};

} // namespace hipmap
