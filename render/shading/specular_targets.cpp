#include "render/shading/specular_targets.h"

#include "common/math/bounds.h"
#include "render/shading/material_traits.h"

#include <algorithm>
#include <span>

namespace hipmap {

namespace {

/// Room for rounding, so that no face reaches out of its sphere.
constexpr float kMargin = 1 + 1e-5f;

/// Halvings of the specular faces; no more than 2 to this power of spheres.
constexpr int kHalvings = 5;
static_assert(std::size_t{1} << kHalvings <= kMostTargets);

Bounds<glm::vec3> box_of(const TriangleMesh& mesh, std::span<const FaceId> faces)
{
    Bounds<glm::vec3> box;
    for (const FaceId face : faces)
        for (const glm::vec3& corner : mesh.triangle(face))
            box.add(corner);
    return box;
}

TargetSphere sphere_around(const TriangleMesh& mesh, std::span<const FaceId> faces)
{
    TargetSphere out{box_of(mesh, faces).centre()};
    for (const FaceId face : faces)
        for (const glm::vec3& corner : mesh.triangle(face))
            out.radius = std::max(out.radius, glm::distance(out.centre, corner));
    out.radius *= kMargin;
    return out;
}

float squared_radii(std::span<const TargetSphere> spheres)
{
    float sum = 0;
    for (const TargetSphere& sphere : spheres)
        sum += sphere.radius * sphere.radius;
    return sum;
}

/// Spheres around the faces: those around their halves on either side of the middle of their
/// longest axis, if those are narrower together, or one.  Reorders the faces.
std::vector<TargetSphere> cover(const TriangleMesh& mesh, std::span<FaceId> faces, int halvings)
{
    const TargetSphere whole = sphere_around(mesh, faces);
    const Bounds<glm::vec3> box = box_of(mesh, faces);
    const glm::vec3 extent = box.extent();
    const int axis =
        extent.x >= extent.y ? (extent.x >= extent.z ? 0 : 2) : (extent.y >= extent.z ? 1 : 2);
    const auto middle = std::partition(faces.begin(), faces.end(), [&](FaceId face) {
        return centroid(mesh, face)[axis] < box.centre()[axis];
    });
    if (halvings == 0 || middle == faces.begin() || middle == faces.end())
        return {whole};
    std::vector<TargetSphere> parts = cover(mesh, {faces.begin(), middle}, halvings - 1);
    const std::vector<TargetSphere> rest = cover(mesh, {middle, faces.end()}, halvings - 1);
    parts.insert(parts.end(), rest.begin(), rest.end());
    return squared_radii(parts) < squared_radii({&whole, 1}) ? parts : std::vector{whole};
}

bool holds(const TargetSphere& sphere, const Bounds<glm::vec3>& box)
{
    const glm::vec3 farthest =
        glm::max(glm::abs(box.low - sphere.centre), glm::abs(box.high - sphere.centre));
    return glm::length(farthest) <= sphere.radius;
}

} // namespace

std::vector<TargetSphere> find_specular_targets(const Scene& scene, const std::vector<Bsdf>& bsdfs)
{
    const TriangleMesh& mesh = scene.mesh;
    std::vector<std::uint8_t> specular;
    for (std::size_t m = 0; m < scene.materials.size(); ++m)
        specular.push_back(may_be_specular(scene.materials[m], bsdfs[m]));
    std::vector<FaceId> faces;
    const auto add = [&](FaceId first, FaceId end) {
        for (FaceId face = first; face < end; ++face)
            if (specular[mesh.material_of(face)] != 0)
                faces.push_back(face);
    };
    add(0, static_cast<FaceId>(mesh.face_count()));
    for (std::uint32_t i = 0; i < mesh.copies.size() && !faces.empty(); ++i)
        add(mesh.finder.first_face(i),
            mesh.finder.first_face(i) + mesh.shared[mesh.copies[i].shared].count);
    std::vector<TargetSphere> out;
    if (!faces.empty())
        out = cover(mesh, faces, kHalvings);
    std::erase_if(out, [](const TargetSphere& sphere) { return !(sphere.radius > 0); });
    return out;
}

std::vector<std::uint8_t> find_enclosed_lights(const LightSet& lights,
                                               const std::vector<TargetSphere>& targets)
{
    std::vector<std::uint8_t> out;
    for (const Light& light : lights.lights) {
        const std::optional<LightBounds> around =
            role(light) == LightRole::medium ? std::nullopt : bounds(light);
        out.push_back(around &&
                      std::any_of(targets.begin(), targets.end(), [&](const TargetSphere& sphere) {
                          return holds(sphere, around->box);
                      }));
    }
    return out;
}

} // namespace hipmap
