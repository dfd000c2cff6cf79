#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace hipmap {

/// Index of a face (a world-space triangle) in load order; the same in both tools.
using FaceId = std::uint32_t;
using MaterialId = std::uint32_t;
using ObjectId = std::uint32_t;

/// Marks the absence of a face, map or object.
inline constexpr std::uint32_t kNone = 0xffffffffu;

/// Vertex attributes besides position and normal; an array is empty where no vertex has it.
struct VertexAttributes {
    std::array<std::vector<glm::vec2>, 2> uv; ///< [V] of two sets, (0, 0) the texture's top left
    std::vector<glm::vec4> colours;           ///< [V] linear RGBA in [0, 1], multiplies the base
                                              ///<     colour; white where there is none
    std::vector<glm::vec4> tangents; ///< [V] unit, along rising u; w = 1 or -1, bitangent =
                                     ///<     w cross(normal, tangent); zero where there is none
};

/// The triangles of a scene, in scene units (see SceneFrame).
struct TriangleMesh {
    std::vector<glm::vec3> positions; ///< [V] as the file splits them; not welded
    std::vector<glm::vec3> normals;   ///< [V] shading normals, unit; zero where there is none
    VertexAttributes attributes;      ///< those that a material reads
    std::vector<glm::uvec3> corners;  ///< [F] indices into positions, counter-clockwise from
                                      ///<     the front (mirrored transforms undone)
    std::vector<MaterialId> material_of_face; ///< [F]
    std::vector<ObjectId> object_of_face;     ///< [F]
    std::vector<std::string> object_names;    ///< [O]

    std::size_t face_count() const { return corners.size(); }
};

/// Returns the cross product of two edges of a face: along its front normal, with twice its area as
/// length.  In double, so that tiny faces keep their direction.  Zero for a degenerate face.
inline glm::dvec3 scaled_normal(const TriangleMesh& mesh, FaceId face)
{
    const glm::uvec3 c = mesh.corners[face];
    const glm::dvec3 a(mesh.positions[c.x]);
    return glm::cross(glm::dvec3(mesh.positions[c.y]) - a, glm::dvec3(mesh.positions[c.z]) - a);
}

/// Returns the area of a face in square scene units.
inline double face_area(const TriangleMesh& mesh, FaceId face)
{
    return 0.5 * glm::length(scaled_normal(mesh, face));
}

} // namespace hipmap
