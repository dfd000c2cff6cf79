#pragma once

#include "common/scene/mesh.h"

#include <array>

namespace hipmap {

/// A face by itself, in more digits than preprocess has.
struct PlainTriangle {
    using Vector = glm::vec<3, long double>;

    std::array<std::uint32_t, 3> vertices{}; ///< the first of all vertices at the same position
    std::array<Vector, 3> corners;
    Vector normal{0.0L};          ///< twice the area long
    long double least_height = 0; ///< over the longest side
    bool degenerate = false;      ///< a vertex twice, or no area

    /// Linear in the vertices of the mesh.
    PlainTriangle(const TriangleMesh& mesh, FaceId face);

    /// The side from corner c begins and ends at these.
    std::uint32_t start(std::uint32_t c) const { return vertices[c]; }
    std::uint32_t end(std::uint32_t c) const { return vertices[(c + 1) % 3]; }
};

/// Whether two faces are in parallel planes, and have planes to speak of; error: the d of
/// docs/partition_file.md, Seams and contacts.
bool in_parallel_planes(const PlainTriangle& f, const PlainTriangle& g, long double error);

/// Whether a part of side c of `f` that is longer than a point lies on `g`.
bool lies_on(const PlainTriangle& f, std::uint32_t c, const PlainTriangle& g, long double error);

} // namespace hipmap
