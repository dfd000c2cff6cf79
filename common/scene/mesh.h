#pragma once

#include "common/math/bounds.h"
#include "common/scene/face_copies.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace hipmap {

/// Vertex attributes besides position and normal; an array is empty where no vertex has it.
struct VertexAttributes {
    std::array<std::vector<glm::vec2>, 2> uv; ///< [V] of two sets, (0, 0) the texture's top left
    std::vector<glm::vec4> colours;           ///< [V] linear RGBA in [0, 1], multiplies the base
                                              ///<     colour; white where there is none
    std::vector<glm::vec4> tangents; ///< [V] unit, along rising u; w = 1 or -1, bitangent =
                                     ///<     w cross(normal, tangent); zero where there is none
};

/// The triangles of a scene, in scene units (see SceneFrame).  Arrays are by stored face; functions
/// take any face, of a copy too.
struct TriangleMesh {
    std::vector<glm::vec3> positions; ///< [V] as the file splits them; not welded
    std::vector<glm::vec3> normals;   ///< [V] shading normals, unit; zero where there is none
    VertexAttributes attributes;      ///< those that a material reads
    std::vector<glm::uvec3> corners;  ///< [F] indices into positions, counter-clockwise from
                                      ///<     the front (mirrored transforms undone)
    std::vector<MaterialId> material_of_face; ///< [F]
    std::vector<ObjectId> object_of_face;     ///< [F]
    std::vector<std::string> object_names;    ///< [O]
    std::vector<SharedFaces> shared;          ///< that have copies, ascending
    std::vector<FaceCopy> copies;             ///< their faces follow the stored ones, in order
    CopyFinder finder;                        ///< of the copies

    /// Returns the number F of stored faces.
    std::size_t face_count() const { return corners.size(); }
    /// Returns the number of faces with those of copies: ids are below it.
    std::size_t all_face_count() const { return copies.empty() ? corners.size() : finder.end(); }
    bool is_copied(FaceId face) const { return face >= corners.size(); }
    /// Returns the copy that a copied face belongs to.
    const FaceCopy& copy_of(FaceId face) const { return copies[finder.copy_of(face)]; }
    /// Returns the face that a face is a copy of; a stored face itself.
    FaceId stored_face(FaceId face) const
    {
        if (!is_copied(face)) [[likely]]
            return face;
        const std::uint32_t copy = finder.copy_of(face);
        return shared[copies[copy].shared].first + (face - finder.first_face(copy));
    }
    MaterialId material_of(FaceId face) const { return material_of_face[stored_face(face)]; }
    ObjectId object_of(FaceId face) const
    {
        return is_copied(face) ? copy_of(face).object : object_of_face[face];
    }
    /// Returns the three vertices whose attributes a face has.
    const glm::uvec3& vertices_of(FaceId face) const { return corners[stored_face(face)]; }
    /// Returns where the corners of a face are in the scene.
    std::array<glm::vec3, 3> triangle(FaceId face) const
    {
        const glm::uvec3& c = vertices_of(face);
        std::array<glm::vec3, 3> out{positions[c.x], positions[c.y], positions[c.z]};
        if (is_copied(face)) [[unlikely]] {
            const Similarity& place = copy_of(face).place;
            for (glm::vec3& corner : out)
                corner = glm::vec3(place.point(glm::dvec3(corner)));
        }
        return out;
    }
};

/// Returns the mean of the corners of a face.
inline glm::vec3 centroid(const TriangleMesh& mesh, FaceId face)
{
    const auto [a, b, c] = mesh.triangle(face);
    return (a + b + c) / 3.0f;
}

/// Returns the cross product of two edges of a face: along its front normal, with twice its area as
/// length.  In double, so that tiny faces keep their direction.  Zero for a degenerate face.
inline glm::dvec3 scaled_normal(const TriangleMesh& mesh, FaceId face)
{
    const glm::uvec3 c = mesh.vertices_of(face);
    const glm::dvec3 a(mesh.positions[c.x]);
    const glm::dvec3 normal =
        glm::cross(glm::dvec3(mesh.positions[c.y]) - a, glm::dvec3(mesh.positions[c.z]) - a);
    if (!mesh.is_copied(face)) [[likely]]
        return normal;
    const Similarity& place = mesh.copy_of(face).place;
    return place.scale * place.scale * place.direction(normal);
}

/// Returns the area of a face in square scene units.
inline double face_area(const TriangleMesh& mesh, FaceId face)
{
    return 0.5 * glm::length(scaled_normal(mesh, face));
}

} // namespace hipmap
