#pragma once

#include "common/scene/gltf_nodes.h"
#include "common/scene/raw_scene.h"

#include <tiny_gltf.h>

#include <optional>
#include <vector>

namespace hipmap {

/// Says which instances of meshes are copies of faces that are stored already: those of a mesh
/// without skin and morph targets whose materials neither emit nor let light in, and that turn,
/// scale and move an earlier instance, to between half and twice its size.  So no stage needs
/// lights or media of copies, and one bound of rounding serves all copies.
class GltfSharing {
  public:
    /// scene: with its materials.
    GltfSharing(const tinygltf::Model& model, const RawScene& scene);

    /// Returns whether the mesh of a node may be shared, as far as it does not depend on others.
    bool may_share(const tinygltf::Node& node) const;

    /// Allows copies of a mesh.
    void allow(int mesh) { allowed_[static_cast<std::size_t>(mesh)] = 1; }
    bool is_allowed(const tinygltf::Node& node) const
    {
        return allowed_[static_cast<std::size_t>(node.mesh)] != 0 && may_share(node);
    }

    /// Adds an instance to the scene as a copy for its last object.  Returns false if it has to be
    /// stored.
    bool add_copy(int mesh, const glm::dmat4& to_world, RawScene& scene);

    /// Lets later instances be copies of the faces stored last.
    void add_stored(int mesh, const glm::dmat4& to_world, const SharedFaces& faces,
                    RawScene& scene);

  private:
    struct Stored {
        glm::dmat4 from_world;
        std::uint32_t shared;
    };

    const tinygltf::Model& model_;
    std::vector<std::uint8_t> may_share_;     ///< [meshes] by their materials and targets
    std::vector<std::uint8_t> allowed_;       ///< [meshes]
    std::vector<std::vector<Stored>> stored_; ///< [meshes]
};

} // namespace hipmap
