#include "common/rays/closest_on_triangle.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace hipmap {

namespace {

glm::vec3 closest_on_edge(const glm::vec3& point, const glm::vec3& a, const glm::vec3& b)
{
    const glm::vec3 edge = b - a;
    const float length2 = glm::dot(edge, edge);
    if (!(length2 > 0))
        return a;
    return a + std::clamp(glm::dot(point - a, edge) / length2, 0.0f, 1.0f) * edge;
}

float distance2(const glm::vec3& a, const glm::vec3& b)
{
    return glm::dot(a - b, a - b);
}

} // namespace

glm::vec3 closest_on_triangle(const glm::vec3& point, const glm::vec3& a, const glm::vec3& b,
                              const glm::vec3& c)
{
    const glm::vec3 normal = glm::cross(b - a, c - a);
    const float length2 = glm::dot(normal, normal);
    const auto inside = [&](const glm::vec3& from, const glm::vec3& to) {
        return glm::dot(glm::cross(to - from, point - from), normal) >= 0;
    };
    if (length2 > 0 && inside(a, b) && inside(b, c) && inside(c, a))
        return point - glm::dot(point - a, normal) / length2 * normal;
    glm::vec3 closest = closest_on_edge(point, a, b);
    for (const glm::vec3& other : {closest_on_edge(point, b, c), closest_on_edge(point, c, a)})
        if (distance2(other, point) < distance2(closest, point))
            closest = other;
    return closest;
}

} // namespace hipmap
