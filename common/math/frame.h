#pragma once

#include <glm/glm.hpp>

#include <cmath>

namespace hipmap {

/// A right-handed orthonormal basis whose z axis is a given unit vector. Source: Duff et al. 2017,
/// "Building an Orthonormal Basis, Revisited".
struct Frame {
    glm::vec3 x, y, z;

    explicit Frame(const glm::vec3& unit_z) : z(unit_z)
    {
        const float sign = std::copysign(1.0f, z.z);
        const float a = -1.0f / (sign + z.z);
        const float b = z.x * z.y * a;
        x = {1.0f + sign * z.x * z.x * a, sign * b, -sign * z.x};
        y = {b, sign + z.y * z.y * a, -z.y};
    }

    glm::vec3 to_world(const glm::vec3& local) const
    {
        return x * local.x + y * local.y + z * local.z;
    }

    glm::vec3 to_local(const glm::vec3& world) const
    {
        return {glm::dot(world, x), glm::dot(world, y), glm::dot(world, z)};
    }
};

} // namespace hipmap
