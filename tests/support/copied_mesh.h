#pragma once

#include "common/scene/mesh.h"
#include "common/scene/store_copies.h"
#include "tests/support/tiny_meshes.h"

#include <glm/gtc/quaternion.hpp>

#include <vector>

namespace hipmap::tiny {

/// A place that is turned about an axis, scaled and moved.
inline Similarity place_at(const glm::dvec3& move, double degrees = 0, double scale = 1,
                           const glm::dvec3& axis = {0, 1, 0})
{
    return {glm::mat3_cast(glm::angleAxis(glm::radians(degrees), glm::normalize(axis))), scale,
            move};
}

/// The faces of `rest`, then those of `shared`, which also stand at the places: an object each.
inline TriangleMesh with_copies(const TriangleMesh& rest, const TriangleMesh& shared,
                                const std::vector<Similarity>& places)
{
    TriangleMesh mesh = together(rest, shared);
    const auto first = static_cast<FaceId>(rest.face_count());
    mesh.object_names = {"rest", "stored"};
    for (FaceId face = first; face < mesh.face_count(); ++face)
        mesh.object_of_face[face] = 1;
    mesh.shared = {{first, static_cast<std::uint32_t>(shared.face_count()),
                    static_cast<std::uint32_t>(rest.positions.size()),
                    static_cast<std::uint32_t>(shared.positions.size())}};
    for (const Similarity& place : places) {
        mesh.copies.push_back({0, static_cast<ObjectId>(mesh.object_names.size()), place});
        mesh.object_names.push_back("copy");
    }
    mesh.finder = find_copies(static_cast<FaceId>(mesh.face_count()), mesh.shared, mesh.copies);
    return mesh;
}

/// The same mesh with all faces stored.
inline TriangleMesh stored(TriangleMesh mesh)
{
    store_copies(mesh);
    return mesh;
}

/// Several places, none alike.
inline std::vector<Similarity> some_places()
{
    return {place_at({0.3, 0.1, -0.2}, 40, 0.7), place_at({-0.4, 0.05, 0.3}, 200, 1.6, {1, 2, 0.5}),
            place_at({0.1, -0.3, 0.4}, -75, 1.0, {0.3, 0, 1})};
}

} // namespace hipmap::tiny
