#pragma once

#include "common/scene/gltf_attributes.h"
#include "common/scene/gltf_deformation.h"
#include "common/scene/mesh.h"
#include "common/scene/raw_scene.h"

#include <tiny_gltf.h>

#include <cstdint>
#include <string>
#include <vector>

namespace hipmap {

/// The triangles of one primitive in its mesh's own space; only vertices that a face uses.
struct GltfPrimitive {
    std::vector<glm::dvec3> positions;
    std::vector<glm::dvec3> normals; ///< as authored; empty if there are none
    VertexAttributes attributes;
    GltfDeformation deformation;
    std::vector<glm::uvec3> corners;
    int material = -1; ///< -1: none
};

/// Reads the primitives of meshes; one reader per file, so that its scratch memory is shared.
class GltfMeshReader {
  public:
    GltfMeshReader(const tinygltf::Model& model, const WantedAttributes& wanted, RawScene& scene)
        : model_(model), wanted_(wanted), scene_(scene)
    {
    }

    /// Reads the triangles of mesh `index`: modes triangles, strip and fan, with and without
    /// indices. Points and lines are skipped.  No face is dropped except an incomplete last one.
    /// Throws InputError, naming the primitive: damaged accessors, an index out of range, a number
    /// that is not finite.
    std::vector<GltfPrimitive> read(std::size_t index);

  private:
    GltfPrimitive read_primitive(const tinygltf::Primitive& primitive, const std::string& place);
    std::vector<std::uint32_t> number_used(std::vector<glm::uvec3>& corners,
                                           std::size_t vertex_count);
    std::vector<glm::uvec3> read_corners(const tinygltf::Primitive& primitive,
                                         std::size_t vertex_count, const std::string& place);

    const tinygltf::Model& model_;
    WantedAttributes wanted_;
    RawScene& scene_;
    std::vector<std::uint32_t> local_; ///< file's vertex -> ours; kNone between calls
};

} // namespace hipmap
