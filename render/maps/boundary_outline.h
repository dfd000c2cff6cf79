#pragma once

#include "render/maps/map_boundaries.h"

#include <array>
#include <cstdint>
#include <vector>

namespace hipmap {

/// The point from which a boundary is looked at, and the plane of its face.
struct OutlineQuery {
    MapId map;
    glm::vec3 point;  ///< scene units
    glm::vec3 normal; ///< unit, of the plane that the boundary is projected into
    float radius;     ///< > 0, finite
};

/// Scratch memory of one thread that looks for the boundaries of maps around points.
struct OutlineScratch {
    /// A part of the tree that is still to be looked at, or one segment of it.
    struct Part {
        double distance2; ///< from the point, in space
        std::uint32_t begin, end;
        std::uint32_t node; ///< kNone: the segments alone
    };
    std::vector<Part> open;         ///< a heap, the nearest on top
    std::array<double, 64> hidden2; ///< by sector: beyond this square distance all is hidden
};

/// The largest outline, whatever the radius and the boundary.
inline constexpr std::size_t kExactSegments = 16; ///< up to so many are looked past as they are
inline constexpr std::size_t kMostSegments = 40;
inline constexpr std::size_t kMostParts = 128; ///< of the tree, but for boxes that hold the point

/// Writes to `out` at most kMostSegments segments that hide from the point all that the whole
/// boundary hides, and returns the radius within which that holds: the query's, or less where the
/// boundary is too dense for it, and then the distance of the nearest part that was not looked at
/// (zero in a point where very many segments meet).  Up to kExactSegments within the radius are
/// written as they are.  With more, hidden segments are left out, and distant ones are replaced by
/// a segment in front of their bounding box, so that somewhat less is visible.
/// docs/visible_area.md, Bounded work. Thread-safe with a scratch for each thread.  Cost: bounded
/// by the constants above.
float outline_boundary(const MapBoundaries& boundaries, const OutlineQuery& query,
                       OutlineScratch& scratch, std::vector<BoundarySegment>& out);

} // namespace hipmap
