#pragma once

#include "common/scene/gltf_nodes.h"

#include <tiny_gltf.h>

#include <filesystem>
#include <vector>

namespace hipmap {

/// Returns how many times a node's mesh stands in the scene: once, or as often as
/// EXT_mesh_gpu_instancing says.  Throws InputError, naming the node: damaged accessors, accessors
/// of different counts.
std::size_t count_instances(const tinygltf::Model& model, std::size_t node,
                            const std::filesystem::path& path);

/// Returns the transforms to the world of all instances of a node's mesh, in the file's order.
/// Throws InputError as count_instances does, and if a transform is not finite.
std::vector<glm::dmat4> place_instances(const tinygltf::Model& model, const PlacedNode& at,
                                        const std::filesystem::path& path);

} // namespace hipmap
