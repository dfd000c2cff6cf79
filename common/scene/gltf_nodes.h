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
};

/// The nodes of scene `scene` (or the first; or, without scenes, all roots), depth first.
/// Throws InputError: a node that is its own ancestor or has two parents, a transform that is
/// not finite or not affine.
std::vector<PlacedNode> place_nodes(const tinygltf::Model& model,
                                    const std::filesystem::path& path);

} // namespace hipmap
