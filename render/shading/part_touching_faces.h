#pragma once

#include "common/partition/partition.h"
#include "common/scene/scene.h"

namespace hipmap {

/// Moves apart what lies in one plane and would be met in an order that rounding decides: glass,
/// panes, bounds of fog, closed leaves and faces that emit, where they lie on another face.  A face
/// of a closed surface moves into it, an open one to the front of the other face, one that emits
/// forwards, by eight times the partition's position error.  What is left between them is air.  The
/// vertices of the same object at the same places move along.  Returns how many faces moved.
/// Cost: nothing in a scene without such faces, else O(faces log faces) unless very many lie about
/// one place.  In parallel; deterministic.
std::size_t part_touching_faces(Scene& scene, const Partition& partition);

} // namespace hipmap
