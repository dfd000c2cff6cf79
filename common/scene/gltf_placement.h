#pragma once

#include "common/scene/gltf_attributes.h"
#include "common/scene/gltf_nodes.h"
#include "common/scene/raw_scene.h"

#include <tiny_gltf.h>

#include <cstdint>
#include <limits>
#include <vector>

namespace hipmap {

/// As the least number of copied faces: there are no copies.
inline constexpr std::uint64_t kNever = std::numeric_limits<std::uint64_t>::max();

/// Appends the meshes of all nodes to the scene, each as often as the file places it: an object for
/// every node, in the order of the nodes, then of its instances, then of its primitives. Each mesh
/// is read once.  Instances whose faces need not be stored again become copies, as gltf_sharing.h
/// says, if they would add least_copied faces; kNever: never.  Throws InputError: as
/// GltfMeshReader, damaged instances, more than 2^32 - 2 faces or vertices, or more than memory
/// holds.
void place_meshes(const tinygltf::Model& model, const std::vector<PlacedNode>& nodes,
                  const WantedAttributes& wanted, std::uint64_t least_copied, RawScene& scene);

} // namespace hipmap
