#pragma once

#include "common/scene/mesh.h"

#include <cstddef>

namespace hipmap {

/// Edges by how many faces they have.
struct EdgeCount {
    std::size_t border = 0;  ///< of one face
    std::size_t pairs = 0;   ///< of two
    std::size_t several = 0; ///< of three or more

    bool closed_manifold() const { return pairs > 0 && border == 0 && several == 0; }
};

/// Counts the edges of a mesh, or of each of its objects by itself; vertices at one position are
/// one, and faces with a position twice are none.  Sorts, and shares no code with preprocess.
/// by_object: whether objects are counted apart.  Returns one count, or [O].
/// O(n log n), one thread.
std::vector<EdgeCount> count_edges(const TriangleMesh& mesh, bool by_object);

} // namespace hipmap
