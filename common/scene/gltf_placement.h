#pragma once

#include "common/scene/gltf_attributes.h"
#include "common/scene/gltf_nodes.h"
#include "common/scene/raw_scene.h"

#include <tiny_gltf.h>

#include <vector>

namespace hipmap {

/// Appends the meshes of all nodes to the scene, each as often as the file places it: an object for
/// every node, in the order of the nodes, then of its instances, then of its primitives. Each mesh
/// is read once.  Throws InputError: as GltfMeshReader, damaged instances, more than 2^32 - 2 faces
/// or vertices, or more than memory holds.
void place_meshes(const tinygltf::Model& model, const std::vector<PlacedNode>& nodes,
                  const WantedAttributes& wanted, RawScene& scene);

} // namespace hipmap
