#pragma once

#include "preprocess/prediction/light_starts.h"

namespace hipmap {

/// Returns at most 32 spheres around the faces of materials that make caustics, those of copies
/// too; none if there are no such faces.  Of more than 65,536 faces only so many, evenly spread
/// over their numbers, are looked at. One thread.
std::vector<BoundingSphere> find_caustic_targets(const TriangleMesh& mesh,
                                                 std::span<const MeanMaterial> materials);

} // namespace hipmap
