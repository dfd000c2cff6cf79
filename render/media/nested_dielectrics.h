#pragma once

#include "common/partition/partition.h"
#include "common/scene/scene.h"

#include <vector>

namespace hipmap {

/// Finds the materials with a surface between dielectrics of closed meshes: some face of one, seen
/// from its front, lies in another such mesh, or the reverse.  docs/media.md (12). Returns [M], 1:
/// the material is one of those.  Cost: O(F) where no two such meshes have overlapping boxes, else
/// two rays through all of them for each face of those that have; in parallel.
std::vector<std::uint8_t> nested_dielectrics(const Scene& scene, const Partition& partition);

} // namespace hipmap
