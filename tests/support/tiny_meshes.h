#pragma once

#include "common/math/random.h"
#include "common/scene/mesh.h"
#include "common/scene/scene.h"

#include <glm/gtc/constants.hpp>

#include <cmath>
#include <utility>
#include <vector>

namespace hipmap::tiny {

/// A mesh of one material and one object, without shading normals.
inline TriangleMesh make_mesh(std::vector<glm::vec3> positions, std::vector<glm::uvec3> corners)
{
    TriangleMesh mesh;
    mesh.normals.assign(positions.size(), glm::vec3(0.0f));
    mesh.material_of_face.assign(corners.size(), 0);
    mesh.object_of_face.assign(corners.size(), 0);
    mesh.object_names = {"tiny"};
    mesh.positions = std::move(positions);
    mesh.corners = std::move(corners);
    return mesh;
}

/// A scene of the mesh as it stands, with one white material and the default camera.
inline Scene make_scene(TriangleMesh mesh)
{
    Scene scene;
    scene.mesh = std::move(mesh);
    scene.materials.resize(1);
    scene.cameras.resize(1);
    return scene;
}

/// Returns the faces of a mesh with three vertices of their own each.
inline TriangleMesh split_all(const TriangleMesh& mesh)
{
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> corners;
    for (const glm::uvec3& c : mesh.corners) {
        const auto first = static_cast<std::uint32_t>(positions.size());
        positions.insert(positions.end(),
                         {mesh.positions[c.x], mesh.positions[c.y], mesh.positions[c.z]});
        corners.emplace_back(first, first + 1, first + 2);
    }
    return make_mesh(std::move(positions), std::move(corners));
}

/// Both meshes as they stand, not joined.
inline TriangleMesh together(const TriangleMesh& a, const TriangleMesh& b)
{
    std::vector<glm::vec3> positions = a.positions;
    std::vector<glm::uvec3> corners = a.corners;
    positions.insert(positions.end(), b.positions.begin(), b.positions.end());
    for (const glm::uvec3& c : b.corners)
        corners.push_back(c + static_cast<std::uint32_t>(a.positions.size()));
    return make_mesh(std::move(positions), std::move(corners));
}

/// Winds one face the other way.
inline void flip(TriangleMesh& mesh, FaceId face)
{
    std::swap(mesh.corners[face].y, mesh.corners[face].z);
}

/// Unit cube about the origin, four vertices a side as exporters write it: 24 vertices, 12 faces,
/// fronts outward.
inline TriangleMesh cube()
{
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> corners;
    for (int axis = 0; axis < 3; ++axis) {
        for (const float sign : {-1.0f, 1.0f}) {
            const auto first = static_cast<std::uint32_t>(positions.size());
            for (const glm::vec2& uv : {glm::vec2(-0.5f, -0.5f), glm::vec2(0.5f, -0.5f),
                                        glm::vec2(0.5f, 0.5f), glm::vec2(-0.5f, 0.5f)}) {
                glm::vec3 p;
                p[axis] = 0.5f * sign;
                p[(axis + 1) % 3] = uv.x * sign;
                p[(axis + 2) % 3] = uv.y;
                positions.push_back(p);
            }
            corners.emplace_back(first, first + 1, first + 2);
            corners.emplace_back(first, first + 2, first + 3);
        }
    }
    return make_mesh(std::move(positions), std::move(corners));
}

/// The cube without its top (+y): 10 faces.
inline TriangleMesh open_box()
{
    TriangleMesh mesh = cube();
    std::vector<glm::uvec3> corners;
    for (FaceId face = 0; face < mesh.face_count(); ++face)
        if (!(scaled_normal(mesh, face).y > 0.5))
            corners.push_back(mesh.corners[face]);
    return make_mesh(std::move(mesh.positions), std::move(corners));
}

/// Unit square in the plane z = 0, facing +z: 2 faces.
inline TriangleMesh quad()
{
    return make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
}

/// A disc of `faces` triangles around its centre, facing +z.
inline TriangleMesh fan(std::uint32_t faces)
{
    std::vector<glm::vec3> positions{{0, 0, 0}};
    std::vector<glm::uvec3> corners;
    for (std::uint32_t i = 0; i < faces; ++i) {
        const float angle =
            glm::two_pi<float>() * static_cast<float>(i) / static_cast<float>(faces);
        positions.emplace_back(std::cos(angle), std::sin(angle), 0.0f);
        corners.emplace_back(0, 1 + i, 1 + (i + 1) % faces);
    }
    return make_mesh(std::move(positions), std::move(corners));
}

/// The corner of a cube: 4 faces, fronts outward.
inline TriangleMesh tetrahedron()
{
    return make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                     {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
}

/// Three faces on one edge.
inline TriangleMesh fin()
{
    return make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}},
                     {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
}

/// Two faces that touch in one vertex.
inline TriangleMesh bow_tie()
{
    return make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}},
                     {{0, 1, 2}, {0, 3, 4}});
}

/// A quad whose second face is wound the other way.
inline TriangleMesh flipped_pair()
{
    TriangleMesh mesh = quad();
    flip(mesh, 1);
    return mesh;
}

/// One face twice.
inline TriangleMesh doubled()
{
    return make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 1, 2}});
}

/// A quad with a face that repeats a vertex and one whose corners lie on a line.
inline TriangleMesh degenerate()
{
    return make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5f, 0.5f, 0}},
                     {{0, 1, 2}, {0, 2, 2}, {0, 4, 2}, {0, 2, 3}});
}

/// A strip of `quads` squares closed to a ring after half a turn: it has one side.
inline TriangleMesh moebius(std::uint32_t quads)
{
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> corners;
    for (std::uint32_t i = 0; i < quads; ++i) {
        const float turn = glm::two_pi<float>() * static_cast<float>(i) / static_cast<float>(quads);
        for (const float side : {-0.3f, 0.3f}) {
            const float radius = 1 + side * std::cos(turn / 2);
            positions.emplace_back(radius * std::cos(turn), radius * std::sin(turn),
                                   side * std::sin(turn / 2));
        }
        const bool last = i + 1 == quads;
        const std::uint32_t a = 2 * i;
        const std::uint32_t low = last ? 1 : a + 2;
        const std::uint32_t high = last ? 0 : a + 3;
        corners.emplace_back(a, low, a + 1);
        corners.emplace_back(a + 1, low, high);
    }
    return make_mesh(std::move(positions), std::move(corners));
}

/// Unit sphere of rings and segments, poles on y, fronts outward, no vertex twice.
inline TriangleMesh uv_sphere(std::uint32_t segments, std::uint32_t rings)
{
    std::vector<glm::vec3> positions{{0, 1, 0}, {0, -1, 0}};
    for (std::uint32_t r = 1; r < rings; ++r)
        for (std::uint32_t s = 0; s < segments; ++s) {
            const float theta =
                glm::pi<float>() * static_cast<float>(r) / static_cast<float>(rings);
            const float phi =
                glm::two_pi<float>() * static_cast<float>(s) / static_cast<float>(segments);
            positions.emplace_back(std::sin(theta) * std::sin(phi), std::cos(theta),
                                   std::sin(theta) * std::cos(phi));
        }
    std::vector<glm::uvec3> corners;
    const auto at = [&](std::uint32_t r, std::uint32_t s) {
        return 2 + (r - 1) * segments + s % segments;
    };
    for (std::uint32_t s = 0; s < segments; ++s) {
        corners.emplace_back(0, at(1, s), at(1, s + 1));
        for (std::uint32_t r = 1; r + 1 < rings; ++r) {
            corners.emplace_back(at(r, s), at(r + 1, s), at(r + 1, s + 1));
            corners.emplace_back(at(r, s), at(r + 1, s + 1), at(r, s + 1));
        }
        corners.emplace_back(1, at(rings - 1, s + 1), at(rings - 1, s));
    }
    return make_mesh(std::move(positions), std::move(corners));
}

/// A tube of radius `thickness` round the unit circle in the plane of x and y, fronts outward.
inline TriangleMesh torus(std::uint32_t along, std::uint32_t round, float thickness)
{
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> corners;
    const auto at = [&](std::uint32_t i, std::uint32_t j) { return i % along * round + j % round; };
    for (std::uint32_t i = 0; i < along; ++i)
        for (std::uint32_t j = 0; j < round; ++j) {
            const float u =
                glm::two_pi<float>() * static_cast<float>(i) / static_cast<float>(along);
            const float v =
                glm::two_pi<float>() * static_cast<float>(j) / static_cast<float>(round);
            const float out = 1 + thickness * std::cos(v);
            positions.emplace_back(out * std::cos(u), out * std::sin(u), thickness * std::sin(v));
            corners.emplace_back(at(i, j), at(i + 1, j), at(i + 1, j + 1));
            corners.emplace_back(at(i, j), at(i + 1, j + 1), at(i, j + 1));
        }
    return make_mesh(std::move(positions), std::move(corners));
}

/// `faces` triangles among a few vertices in [-1, 1]^3: edges of three and more faces, repeated
/// and doubled corners, every winding.  Coordinates are multiples of 1/2, so that some vertices
/// coincide and some faces are flat.
inline TriangleMesh random_mesh(std::uint64_t seed, std::uint32_t vertices, std::uint32_t faces)
{
    RandomSequence random(seed, RandomStream::pictures, 0, 0);
    const auto below = [&](std::uint32_t n) {
        return static_cast<std::uint32_t>(random.next() * static_cast<float>(n));
    };
    std::vector<glm::vec3> positions;
    for (std::uint32_t v = 0; v < vertices; ++v) {
        const auto coordinate = [&] { return 0.5f * static_cast<float>(below(5)) - 1; };
        const float x = coordinate();
        const float y = coordinate();
        positions.emplace_back(x, y, coordinate());
    }
    std::vector<glm::uvec3> corners;
    for (std::uint32_t f = 0; f < faces; ++f) {
        const std::uint32_t a = below(vertices);
        const std::uint32_t b = below(vertices);
        corners.emplace_back(a, b, below(vertices));
    }
    return make_mesh(std::move(positions), std::move(corners));
}

} // namespace hipmap::tiny
