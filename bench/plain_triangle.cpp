#include "bench/plain_triangle.h"

#include <algorithm>
#include <cmath>

namespace hipmap {

PlainTriangle::PlainTriangle(const TriangleMesh& mesh, FaceId face)
{
    for (int c = 0; c < 3; ++c) {
        const glm::vec3& position = mesh.positions[mesh.corners[face][c]];
        while (mesh.positions[vertices[c]] != position)
            ++vertices[c];
        corners[c] = Vector(position);
    }
    normal = glm::cross(corners[2] - corners[1], corners[0] - corners[1]);
    degenerate = vertices[0] == vertices[1] || vertices[1] == vertices[2] ||
                 vertices[2] == vertices[0] || normal == Vector(0.0L);
    if (degenerate)
        return;
    long double longest = 0;
    for (int c = 0; c < 3; ++c)
        longest = std::max(longest, glm::length(corners[(c + 1) % 3] - corners[c]));
    least_height = glm::length(normal) / longest;
}

bool in_parallel_planes(const PlainTriangle& f, const PlainTriangle& g, long double error)
{
    if (f.least_height < 16 * error || g.least_height < 16 * error)
        return false;
    const long double sine =
        glm::length(glm::cross(f.normal, g.normal)) / glm::length(f.normal) / glm::length(g.normal);
    return sine <= 8 * error / f.least_height + 8 * error / g.least_height;
}

bool lies_on(const PlainTriangle& f, std::uint32_t c, const PlainTriangle& g, long double error)
{
    using Vector = PlainTriangle::Vector;
    const Vector begin = f.corners[c];
    const Vector along = f.corners[(c + 1) % 3] - begin;
    long double from = 0, to = 1;
    // Keeps the part of the side that is no farther than `slack` behind a plane.
    const auto keep_before = [&](const Vector& origin, const Vector& direction, long double slack) {
        const long double height = glm::dot(begin - origin, direction) + slack;
        const long double rise = glm::dot(along, direction);
        if (rise > 0)
            from = std::max(from, -height / rise);
        else if (rise < 0)
            to = std::min(to, -height / rise);
        else if (height < 0)
            to = from;
    };
    const Vector up = glm::normalize(g.normal);
    keep_before(g.corners[0], up, 2 * error);
    keep_before(g.corners[0], -up, 2 * error);
    for (int side = 0; side < 3; ++side) {
        const Vector edge = g.corners[(side + 1) % 3] - g.corners[side];
        keep_before(g.corners[side], glm::normalize(glm::cross(up, edge)), error);
    }
    return (to - from) * glm::length(along) > 64 * error;
}

} // namespace hipmap
