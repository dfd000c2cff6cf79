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

} // namespace hipmap
