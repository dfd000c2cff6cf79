#pragma once

#include "tests/support/tiny_meshes.h"

#include <glm/gtc/quaternion.hpp>

#include <functional>

namespace hipmap::tiny {

/// A grid of `columns` by `rows` squares over [0, 1]^2, bent by `place`, without the squares that
/// `hole(column, row)` names.  Corners shared by squares are shared vertices.
inline TriangleMesh bent_grid(
    std::uint32_t columns, std::uint32_t rows, const std::function<glm::vec3(glm::vec2)>& place,
    const std::function<bool(std::uint32_t, std::uint32_t)>& hole = [](auto, auto) {
        return false;
    })
{
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> corners;
    for (std::uint32_t j = 0; j <= rows; ++j)
        for (std::uint32_t i = 0; i <= columns; ++i)
            positions.push_back(place(glm::vec2(i, j) / glm::vec2(columns, rows)));
    for (std::uint32_t j = 0; j < rows; ++j)
        for (std::uint32_t i = 0; i < columns; ++i) {
            if (hole(i, j))
                continue;
            const std::uint32_t a = j * (columns + 1) + i;
            corners.emplace_back(a, a + 1, a + columns + 2);
            corners.emplace_back(a, a + columns + 2, a + columns + 1);
        }
    return make_mesh(std::move(positions), std::move(corners));
}

/// A floor with a slit along x = 1/2, `width` wide, from y = 0 to 3/4.
inline TriangleMesh slit_floor(std::uint32_t cells, float width)
{
    const std::uint32_t columns = 2 * cells + 1;
    return bent_grid(
        columns, 4 * cells,
        [&](glm::vec2 p) {
            const float i = std::round(p.x * static_cast<float>(columns));
            const float half = 0.5f * (1 - width);
            const auto n = static_cast<float>(cells);
            return glm::vec3(i <= n ? half * i / n : half + width + half * (i - n - 1) / n, p.y, 0);
        },
        [&](std::uint32_t i, std::uint32_t j) { return i == cells && j < 3 * cells; });
}

/// A sheet that goes out, round a half circle of `gap` across, and back.
inline TriangleMesh hairpin(std::uint32_t cells, float gap)
{
    const std::uint32_t bend = 12;
    const std::uint32_t columns = 2 * cells + bend;
    return bent_grid(columns, cells, [&](glm::vec2 p) {
        const float i = std::round(p.x * static_cast<float>(columns));
        const auto n = static_cast<float>(cells), b = static_cast<float>(bend);
        if (i <= n)
            return glm::vec3(i / n, p.y, 0);
        if (i >= n + b)
            return glm::vec3((2 * n + b - i) / n, p.y, gap);
        const float angle = glm::pi<float>() * (i - n) / b;
        return glm::vec3(1 + 0.5f * gap * std::sin(angle), p.y, 0.5f * gap * (1 - std::cos(angle)));
    });
}

/// A closed shell: a sphere pressed flat to `thickness` times its height.
inline TriangleMesh thin_shell(std::uint32_t segments, float thickness)
{
    TriangleMesh mesh = uv_sphere(segments, segments / 2 + 1);
    for (glm::vec3& p : mesh.positions)
        p.y *= thickness;
    return mesh;
}

/// A floor one half of which is twice as fine; the halves share vertices only at every other place
/// of the seam at x = 1/2, where the fine half has T-junctions.
inline TriangleMesh t_junction_floor(std::uint32_t cells)
{
    return together(
        bent_grid(cells, cells, [](glm::vec2 p) { return glm::vec3(0.5f * p.x, p.y, 0); }),
        bent_grid(cells, 2 * cells,
                  [](glm::vec2 p) { return glm::vec3(0.5f + 0.5f * p.x, p.y, 0); }));
}

/// A fan of which `missing` of its faces are left out.
inline TriangleMesh notched_fan(std::uint32_t faces, std::uint32_t missing)
{
    TriangleMesh mesh = fan(faces);
    mesh.corners.resize(faces - missing);
    return make_mesh(mesh.positions, mesh.corners);
}

/// A rotation that the seed chooses.
inline glm::quat random_rotation(std::uint64_t seed)
{
    RandomSequence random(seed, RandomStream::pictures, 1, 0);
    glm::vec4 q;
    do {
        const glm::vec2 a = random.next2(), b = random.next2();
        q = glm::vec4(a, b) * 2.0f - 1.0f;
    } while (glm::dot(q, q) > 1 || glm::dot(q, q) < 0.01f);
    q = glm::normalize(q);
    return glm::quat(q.w, q.x, q.y, q.z);
}

/// Turns and scales a mesh about the origin, then moves it.
inline void transform(TriangleMesh& mesh, const glm::quat& rotation, float scale = 1.0f,
                      const glm::vec3& move = glm::vec3(0.0f))
{
    for (glm::vec3& p : mesh.positions)
        p = scale * (rotation * p) + move;
}

/// Moves every vertex by up to `size` on each axis.
inline void jitter(TriangleMesh& mesh, float size, std::uint64_t seed)
{
    RandomSequence random(seed, RandomStream::pictures, 2, 0);
    for (glm::vec3& p : mesh.positions)
        for (int axis = 0; axis < 3; ++axis)
            p[axis] += size * (2 * random.next() - 1);
}

} // namespace hipmap::tiny
