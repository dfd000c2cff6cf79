#pragma once

#include "common/scene/gltf_attributes.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace hipmap {

/// A vertex that a morph target moves.
struct Displacement {
    std::uint32_t vertex = 0;
    glm::vec3 by{0.0f}; ///< not zero, in the mesh's space
};

/// A morph target (shape key): what it adds to vertices, in their order.
struct MorphTarget {
    std::vector<Displacement> positions, normals, tangents;
};

/// The share of a vertex that follows a joint of a skin.
struct JointShare {
    std::uint32_t joint = 0; ///< number in the list of the skin
    float share = 0.0f;      ///< 0 or more; those of a vertex sum to one
};

/// How the vertices of a primitive can move: by morph targets, then by the joints of a skin.
struct GltfDeformation {
    std::vector<MorphTarget> targets;  ///< [T]
    std::vector<JointShare> shares;    ///< [V joints_per_vertex]
    std::size_t joints_per_vertex = 0; ///< 0: no vertex follows a joint
};

/// Reads the morph targets and joints of a primitive for the vertices used, in their order.
/// Throws InputError, naming the attribute: a damaged accessor, a type or count that glTF does not
/// allow, a number that is not finite, more displacements than the file has bytes.
GltfDeformation read_deformation(const PrimitivePlace& at, const UsedVertices& used);

} // namespace hipmap
