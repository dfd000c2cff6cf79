#pragma once

#include "common/partition/partition.h"
#include "common/scene/scene.h"

#include <vector>

namespace hipmap {

/// Which materials have a surface between dielectrics of closed meshes: some face of one, seen from
/// its front, lies in another mesh of them, or they do in it.  docs/media.md (12).
/// Returns [M], 1: the material is one of those.  Cost: O(F) where no two such meshes have
/// overlapping boxes, else two rays through all of them for each face of those that have; in
/// parallel.
std::vector<std::uint8_t> nested_dielectrics(const Scene& scene, const Partition& partition);

} // namespace hipmap
