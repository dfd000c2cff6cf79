#pragma once

#include <glm/glm.hpp>

#include <limits>

namespace hipmap {

/// An axis-aligned box; empty until a point is added.
template <typename Vec>
struct Bounds {
    using Scalar = typename Vec::value_type;

    Vec low{std::numeric_limits<Scalar>::infinity()};
    Vec high{-std::numeric_limits<Scalar>::infinity()};

    void add(const Vec& point)
    {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    bool empty() const { return !(low.x <= high.x); }
    Vec centre() const { return low + (high - low) * Scalar(0.5); }
    Vec extent() const { return high - low; }
};

/// Returns the axis along which a vector without signs is longest; of equals the first.
inline int longest_axis(const glm::vec3& extent)
{
    if (extent.x >= extent.y && extent.x >= extent.z)
        return 0;
    return extent.y >= extent.z ? 1 : 2;
}

} // namespace hipmap
