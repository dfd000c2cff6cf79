#pragma once

#include <glm/glm.hpp>
#include <tiny_gltf.h>

#include <filesystem>
#include <vector>

namespace hipmap {

/// A node of the default scene with its transform to the world.
struct PlacedNode {
    std::size_t node = 0;
    glm::dmat4 to_world{1.0};
    bool visible = true; ///< false: KHR_node_visibility hides it or an ancestor
};

/// A transform in parts, applied scale first.
struct NodeTransform {
    glm::dvec3 translation{0.0};
    glm::dvec4 rotation{0, 0, 0, 1}; ///< quaternion x, y, z, w of any length; zero: no rotation
    glm::dvec3 scale{1.0};
};

glm::dmat4 to_matrix(const NodeTransform& transform);

bool is_finite_transform(const glm::dmat4& m);

/// Returns the nodes of scene `scene` (or the first; or, without scenes, all roots), depth first.
/// Throws InputError: a node that is its own ancestor or has two parents, a transform that is not
/// finite or not affine.
std::vector<PlacedNode> place_nodes(const tinygltf::Model& model,
                                    const std::filesystem::path& path);

} // namespace hipmap
