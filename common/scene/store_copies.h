#pragma once

#include "common/scene/mesh.h"

#include <span>

namespace hipmap {

/// Returns the box of all faces, those of copies included, exactly as if they were stored.  Cost:
/// linear in the stored vertices, and in those of copies that reach out of the box of the others.
Bounds<glm::vec3> bounds_of(const TriangleMesh& mesh);

/// Stores the faces of all copies behind the others, under the same numbers.  There are no copies
/// afterwards.  Memory: that of every copy.
void store_copies(TriangleMesh& mesh);

/// Stores faces of their own for some places at which shared faces stand, behind the other stored
/// ones; faces of the copies that are left get new numbers.  places: ascending; place i, below the
/// number of shared faces, is where shared faces i are stored, and the others are the copies in
/// their order.  Shared faces that lose their place move to that of their first copy.
void set_apart(TriangleMesh& mesh, std::span<const std::uint32_t> places);

} // namespace hipmap
