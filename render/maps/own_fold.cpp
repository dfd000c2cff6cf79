#include "render/maps/own_fold.h"

#include "render/maps/plane_directions.h"

#include <algorithm>
#include <utility>

namespace hipmap {

SegmentParts parts_on_fold(const OwnFold& fold, const PlanePoint& a, const PlanePoint& b)
{
    const SegmentParts whole{{{{0, 1}}}, 1};
    const double side = std::abs(a.height) >= std::abs(b.height) ? a.height : b.height;
    const double turn = side < 0 ? -1 : 1;
    const double from = turn * a.height - fold.slack, to = turn * b.height - fold.slack;
    const double highest = std::max(from, to);
    if (!(highest > 0) || highest * highest <= distance2(a.at, b.at))
        return whole;
    // The distance is convex and the height linear: within one interval it lies too high.
    const glm::dvec2 along = b.at - a.at;
    const double climb = to - from;
    const double square = glm::dot(along, along) - climb * climb;
    const double half = glm::dot(a.at, along) - from * climb;
    const double constant = glm::dot(a.at, a.at) - from * from;
    const double inside2 = half * half - square * constant;
    if (!(inside2 > 0))
        return whole;
    const double q = -(half + std::copysign(std::sqrt(inside2), half));
    double low = std::min(q / square, constant / q);
    double high = std::max(q / square, constant / q);
    if (square < 0 && climb > 0) // steeper than the cone: from one root on
        low = std::exchange(high, 2.0);
    else if (square < 0)
        high = std::exchange(low, -1.0);
    low = std::clamp(low, 0.0, 1.0);
    high = std::clamp(high, 0.0, 1.0);
    if (!(low < high) || !(from + (low + high) / 2 * climb > 0))
        return whole;
    SegmentParts out;
    out.add(0, low);
    out.add(high, 1);
    return out;
}

} // namespace hipmap
