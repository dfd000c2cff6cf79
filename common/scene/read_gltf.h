#pragma once

#include "common/scene/gltf_animation.h"
#include "common/scene/gltf_document.h"
#include "common/scene/raw_scene.h"

#include <tiny_gltf.h>

#include <filesystem>
#include <optional>

namespace hipmap {

/// A .gltf or .glb file that is read once, of which any moment can be had: the default scene's
/// nodes with all their instances.  Faces come in the order of a depth-first walk, so the same file
/// gives the same faces, at any time.  Not for several threads at once.
class GltfSource {
  public:
    /// Throws InputError with the place and what is wrong.
    explicit GltfSource(const std::filesystem::path& path);

    /// time: of the animation, s; none: the nodes as they stand in the file.  last: nothing will be
    /// asked for afterwards, so textures need not be copied.  Throws likewise.
    RawScene at(std::optional<double> time, bool last);

  private:
    GltfDocument document_;
    tinygltf::Model model_;
    std::vector<tinygltf::Node> rest_; ///< the model's nodes as in the file
    RawScene timeless_;                ///< materials, textures and what the audit says of them
    GltfAnimation animation_;
    std::optional<SceneSweep> sweep_;
    bool swept_ = false;
};

} // namespace hipmap
