#include "preprocess/prediction/caustic_targets.h"

#include <algorithm>

namespace hipmap {

namespace {

constexpr int kHalvings = 5;

/// Scenes with more faces are sampled, at a fixed step: the spheres need not be exact.
constexpr std::uint64_t kMostFaces = 1 << 16;

struct Covered {
    std::vector<BoundingSphere> spheres;
    float squared_radii = 0;
};

Bounds<glm::vec3> box_of(const TriangleMesh& mesh, FaceId face)
{
    Bounds<glm::vec3> box;
    for (const glm::vec3& corner : mesh.triangle(face))
        box.add(corner);
    return box;
}

BoundingSphere sphere_around(const TriangleMesh& mesh, std::span<const FaceId> faces,
                             const glm::vec3& centre)
{
    BoundingSphere out{centre, 0};
    for (const FaceId face : faces)
        for (const glm::vec3& corner : mesh.triangle(face))
            out.radius = std::max(out.radius, glm::distance(centre, corner));
    return out;
}

/// Halves the faces at the middle of their box while that makes the spheres smaller together.
/// Reorders the faces.
Covered cover(const TriangleMesh& mesh, std::span<FaceId> faces, int halvings)
{
    Bounds<glm::vec3> box;
    for (const FaceId face : faces) {
        const Bounds<glm::vec3> of_face = box_of(mesh, face);
        box.add(of_face.low);
        box.add(of_face.high);
    }
    const glm::vec3 extent = box.extent(), centre = box.centre();
    const BoundingSphere one = sphere_around(mesh, faces, centre);
    const Covered whole{{one}, one.radius * one.radius};
    const int axis =
        extent.x >= extent.y ? (extent.x >= extent.z ? 0 : 2) : (extent.y >= extent.z ? 1 : 2);
    const auto middle = std::partition(faces.begin(), faces.end(), [&](FaceId face) {
        return box_of(mesh, face).centre()[axis] < centre[axis];
    });
    if (halvings == 0 || middle == faces.begin() || middle == faces.end())
        return whole;
    Covered parts = cover(mesh, {faces.begin(), middle}, halvings - 1);
    const Covered rest = cover(mesh, {middle, faces.end()}, halvings - 1);
    parts.spheres.insert(parts.spheres.end(), rest.spheres.begin(), rest.spheres.end());
    parts.squared_radii += rest.squared_radii;
    return parts.squared_radii < whole.squared_radii ? parts : whole;
}

} // namespace

std::vector<BoundingSphere> find_caustic_targets(const TriangleMesh& mesh,
                                                 std::span<const MeanMaterial> materials)
{
    std::vector<FaceId> faces;
    if (std::ranges::none_of(materials, makes_caustics))
        return {};
    const std::uint64_t count = mesh.all_face_count(), step = count / kMostFaces + 1;
    for (std::uint64_t face = 0; face < count; face += step)
        if (makes_caustics(materials[mesh.material_of(static_cast<FaceId>(face))]))
            faces.push_back(static_cast<FaceId>(face));
    if (faces.empty())
        return {};
    std::vector<BoundingSphere> out = cover(mesh, faces, kHalvings).spheres;
    std::erase_if(out, [](const BoundingSphere& sphere) { return !(sphere.radius > 0); });
    return out;
}

} // namespace hipmap
