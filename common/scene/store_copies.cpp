#include "common/scene/store_copies.h"

#include "common/scene/copied_bounds.h"

#include <algorithm>

namespace hipmap {

namespace {

template <typename T>
void append_part(std::vector<T>& values, const SharedFaces& faces)
{
    if (values.empty())
        return;
    const std::size_t from = faces.first_vertex;
    for (std::size_t i = 0; i < faces.vertex_count; ++i)
        values.push_back(T(values[from + i]));
}

/// Moves vertices with all that they have.
void move_vertices(TriangleMesh& mesh, std::size_t first, std::size_t count,
                   const Similarity& place)
{
    for (std::size_t v = first; v < first + count; ++v) {
        mesh.positions[v] = glm::vec3(place.point(glm::dvec3(mesh.positions[v])));
        if (!mesh.normals.empty())
            mesh.normals[v] = glm::vec3(place.direction(glm::dvec3(mesh.normals[v])));
        if (!mesh.attributes.tangents.empty()) {
            glm::vec4& tangent = mesh.attributes.tangents[v];
            tangent = glm::vec4(place.direction(glm::dvec3(tangent)), tangent.w);
        }
    }
}

/// Stores faces like shared ones, at a place and for an object.
void store(TriangleMesh& mesh, const FaceCopy& copy)
{
    const SharedFaces faces = mesh.shared[copy.shared];
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    append_part(mesh.positions, faces);
    append_part(mesh.normals, faces);
    for (std::vector<glm::vec2>& uv : mesh.attributes.uv)
        append_part(uv, faces);
    append_part(mesh.attributes.colours, faces);
    append_part(mesh.attributes.tangents, faces);
    move_vertices(mesh, first, faces.vertex_count, copy.place);
    for (FaceId face = faces.first; face < faces.first + faces.count; ++face) {
        mesh.corners.push_back(glm::uvec3(mesh.corners[face]) - faces.first_vertex + first);
        mesh.material_of_face.push_back(MaterialId(mesh.material_of_face[face]));
        mesh.object_of_face.push_back(copy.object);
    }
}

/// Moves shared faces to the place of one of their copies, and the places of the others with them.
void move_to(TriangleMesh& mesh, const FaceCopy& copy)
{
    const SharedFaces faces = mesh.shared[copy.shared];
    move_vertices(mesh, faces.first_vertex, faces.vertex_count, copy.place);
    std::fill_n(mesh.object_of_face.begin() + faces.first, faces.count, copy.object);
    const Similarity back = inverse(copy.place);
    for (FaceCopy& other : mesh.copies)
        if (other.shared == copy.shared)
            other.place = compose(other.place, back);
}

} // namespace

Bounds<glm::vec3> bounds_of(const TriangleMesh& mesh)
{
    return bounds_with_copies<glm::vec3>(mesh.positions, mesh.shared, mesh.copies);
}

void store_copies(TriangleMesh& mesh)
{
    for (const FaceCopy& copy : mesh.copies)
        store(mesh, copy);
    mesh.copies = {};
    mesh.shared = {};
    mesh.finder = {};
}

void set_apart(TriangleMesh& mesh, std::span<const std::uint32_t> places)
{
    if (places.empty())
        return;
    const auto shared_count = static_cast<std::uint32_t>(mesh.shared.size());
    std::vector<std::uint8_t> loses_place(shared_count, 0);
    std::vector<std::uint8_t> apart(mesh.copies.size(), 0);
    for (const std::uint32_t place : places)
        (place < shared_count ? loses_place[place] : apart[place - shared_count]) = 1;
    // Shared faces without another place left stay where they are.
    std::vector<std::uint32_t> heir(shared_count, kNone);
    for (std::uint32_t i = 0; i < mesh.copies.size(); ++i)
        if (apart[i] == 0 && heir[mesh.copies[i].shared] == kNone)
            heir[mesh.copies[i].shared] = i;
    for (std::uint32_t i = 0; i < shared_count; ++i)
        if (loses_place[i] != 0 && heir[i] != kNone)
            store(mesh, {i, mesh.object_of_face[mesh.shared[i].first], {}});
    for (std::uint32_t i = 0; i < mesh.copies.size(); ++i)
        if (apart[i] != 0)
            store(mesh, mesh.copies[i]);
    for (std::uint32_t i = 0; i < shared_count; ++i)
        if (loses_place[i] != 0 && heir[i] != kNone) {
            apart[heir[i]] = 1;
            move_to(mesh, FaceCopy(mesh.copies[heir[i]]));
        }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < mesh.copies.size(); ++i)
        if (apart[i] == 0)
            mesh.copies[kept++] = mesh.copies[i];
    mesh.copies.resize(kept);
    drop_unshared(mesh.shared, mesh.copies);
    mesh.finder = find_copies(static_cast<FaceId>(mesh.corners.size()), mesh.shared, mesh.copies);
}

} // namespace hipmap
