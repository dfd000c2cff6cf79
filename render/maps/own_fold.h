#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cmath>

namespace hipmap {

/// The part of space around a query that its own fold of the surface lies in: what stands at most
/// as high over the plane of its face as it is away in that plane, docs/visible_area.md (A7). Other
/// folds of the same map, such as the other side of a thin sheet, lie outside but for a wide
/// radius.
struct OwnFold {
    /// Heights that always count, as a share of the radius: so that rounding cuts nothing off.
    static constexpr double kSlack = 1.0 / 16;

    double slack = 0; ///< scene units

    explicit OwnFold(double radius) : slack(kSlack * radius) {}

    /// Returns whether a point belongs to it.  at: in the plane, from the query; height: over it.
    bool contains(const glm::dvec2& at, double height) const
    {
        const double above = std::abs(height) - slack;
        return !(above > 0) || above * above <= glm::dot(at, at);
    }
};

/// A point by its projection into a query's plane, and its height over it.
struct PlanePoint {
    glm::dvec2 at;
    double height;
};

/// Parts of a segment, as ranges of its parameter from 0 to 1.
struct SegmentParts {
    struct Range {
        double from, to;
    };
    std::array<Range, 2> ranges{};
    int count = 0;

    void add(double from, double to)
    {
        if (from < to)
            ranges[static_cast<std::size_t>(count++)] = {from, to};
    }
    bool whole() const { return count == 1 && ranges[0].from == 0 && ranges[0].to == 1; }
    const Range* begin() const { return ranges.data(); }
    const Range* end() const { return ranges.data() + count; }
};

/// Returns the parts of the segment from a to b that lie in the fold.  A segment that leaves it on
/// both sides of the plane is cut only on the side on which it goes farther.
SegmentParts parts_on_fold(const OwnFold& fold, const PlanePoint& a, const PlanePoint& b);

} // namespace hipmap
