#include "common/scene/placement.h"

#include <algorithm>
#include <cmath>

namespace hipmap {

namespace {

/// The matrix of cofactors: the inverse transpose times the determinant, and defined without one.
glm::dmat3 cofactors(const glm::dmat3& m)
{
    return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

} // namespace

Placement placement_of(const glm::dmat4& to_world)
{
    double largest = 0.0;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            largest = std::max(largest, std::abs(to_world[column][row]));
    // Scaled first, so that the products below neither overflow nor vanish.
    const glm::dmat3 linear = largest > 0 ? glm::dmat3(to_world) / largest : glm::dmat3(0.0);
    Placement placement;
    placement.points = to_world;
    placement.normals = cofactors(linear);
    placement.mirrored = glm::dot(linear[0], placement.normals[0]) < 0;
    if (placement.mirrored)
        placement.normals = -placement.normals;
    return placement;
}

glm::vec3 unit_or_zero(const glm::dvec3& v)
{
    const double length = glm::length(v);
    return length > 0 && std::isfinite(length) ? glm::vec3(v / length) : glm::vec3(0.0f);
}

glm::vec4 place_tangent(const glm::vec4& tangent, const Placement& placement)
{
    const glm::vec3 turned = unit_or_zero(glm::dmat3(placement.points) * glm::dvec3(tangent));
    // A mirror image turns a right-handed frame into a left-handed one.
    const bool left_handed = (tangent.w < 0) != placement.mirrored;
    return turned == glm::vec3(0.0f) ? glm::vec4(0.0f) : glm::vec4(turned, left_handed ? -1 : 1);
}

} // namespace hipmap
