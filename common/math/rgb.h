#pragma once

#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>

namespace hipmap {

/// Linear RGB with Rec. 709 primaries: radiance, power, albedo.
using Rgb = glm::vec3;

inline float max_channel(const Rgb& c)
{
    return std::max(c.x, std::max(c.y, c.z));
}

inline float sum_of_channels(const Rgb& c)
{
    return c.x + c.y + c.z;
}

/// Returns the Rec. 709 luminance of a colour.
inline float luminance(const Rgb& c)
{
    return 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z;
}

inline bool is_black(const Rgb& c)
{
    return c.x == 0 && c.y == 0 && c.z == 0;
}

inline bool is_finite(const glm::vec3& v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

} // namespace hipmap
