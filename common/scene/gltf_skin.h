#pragma once

#include "common/scene/gltf_nodes.h"

#include <glm/glm.hpp>
#include <tiny_gltf.h>

#include <filesystem>
#include <vector>

namespace hipmap {

/// The joints that deform a mesh.
struct GltfSkin {
    std::vector<std::size_t> joints;   ///< [J] nodes
    std::vector<glm::dmat4> from_mesh; ///< [J] from the mesh's space to the joint's, as bound
};

/// Reads the skins of a checked file.  Throws InputError, naming the skin: a damaged accessor,
/// fewer matrices than joints, a number that is not finite.
std::vector<GltfSkin> read_gltf_skins(const tinygltf::Model& model,
                                      const std::filesystem::path& path);

/// Returns the transform of each of the file's `count` nodes to the world, borrowed; null where a
/// node is not among those placed.
std::vector<const glm::dmat4*> transforms_by_node(const std::vector<PlacedNode>& nodes,
                                                  std::size_t count);

/// Returns the transforms of a skin's joints from the mesh's space to the world, [J]; none if a
/// joint is not placed.  to_world: of transforms_by_node.
std::vector<glm::dmat4> place_joints(const GltfSkin& skin,
                                     const std::vector<const glm::dmat4*>& to_world);

/// Returns the weights of the morph targets of a node's mesh, by the node, else the mesh; empty:
/// all are zero.
const std::vector<double>& morph_weights(const tinygltf::Model& model, const tinygltf::Node& node);

} // namespace hipmap
