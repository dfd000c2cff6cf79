#pragma once

#include "common/partition/partition.h"
#include "common/scene/scene.h"

namespace hipmap {

/// Separates coplanar faces that rays would meet in an order decided by rounding: glass, panes,
/// bounds of fog, closed leaves and faces that emit, where they lie on another face.  A face of a
/// closed surface moves inwards, an open one to the front of the other face, one that emits
/// forwards, by eight times the partition's position error.  The gap is air.  The vertices of the
/// same object at the same places move along.  Copies move as the faces that they are
/// copies of.  Returns how many stored faces moved. Cost: nothing in a
/// scene without such faces, else O(faces log faces) unless very many lie about one place.  In
/// parallel; deterministic.
std::size_t part_touching_faces(Scene& scene, const Partition& partition);

} // namespace hipmap
