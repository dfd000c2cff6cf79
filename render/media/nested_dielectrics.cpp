#include "render/media/nested_dielectrics.h"

#include "common/math/bounds.h"
#include "common/rays/embree_scene.h"
#include "common/rays/surface_point.h"
#include "render/media/material_insides.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <utility>

namespace hipmap {

namespace {

/// The faces that bound closed dielectrics.
struct Boundaries {
    TriangleMesh mesh;         ///< of them alone
    std::vector<FaceId> faces; ///< [F'] in the scene
};

Boundaries collect(const Scene& scene, const Partition& partition)
{
    Boundaries out;
    for (FaceId face = 0; face < scene.mesh.face_count(); ++face) {
        const Material& material = scene.materials[scene.mesh.material_of(face)];
        if (!partition.is_closed(face) || !is_dielectric(material) ||
            !(face_area(scene.mesh, face) > 0))
            continue;
        out.faces.push_back(face);
        const auto first = static_cast<std::uint32_t>(out.mesh.positions.size());
        for (int c = 0; c < 3; ++c)
            out.mesh.positions.push_back(scene.mesh.positions[scene.mesh.corners[face][c]]);
        out.mesh.corners.emplace_back(first, first + 1, first + 2);
    }
    out.mesh.normals.assign(out.mesh.positions.size(), glm::vec3(0));
    return out;
}

/// A connected surface.
struct Surface {
    std::vector<FaceId> members; ///< of the boundaries
    Bounds<glm::vec3> box;
    bool meets_another = false; ///< its box overlaps that of another
};

std::vector<Surface> connected_surfaces(const Boundaries& boundaries, const Partition& partition)
{
    std::vector<std::uint32_t> place(partition.face_count(), kNone); // of a face still to be met
    for (FaceId i = 0; i < boundaries.faces.size(); ++i)
        place[boundaries.faces[i]] = i;
    std::vector<Surface> out;
    std::vector<FaceId> waiting;
    for (const FaceId seed : boundaries.faces) {
        if (place[seed] == kNone)
            continue;
        Surface surface;
        waiting.assign({seed});
        surface.members.push_back(std::exchange(place[seed], kNone));
        while (!waiting.empty()) {
            const FaceId face = waiting.back();
            waiting.pop_back();
            for (int c = 0; c < 3; ++c) {
                const std::uint32_t beyond = partition.opposite[3 * std::size_t{face} + c];
                if (beyond == kNone || place[beyond / 3] == kNone)
                    continue;
                surface.members.push_back(std::exchange(place[beyond / 3], kNone));
                waiting.push_back(beyond / 3);
            }
        }
        for (const FaceId member : surface.members)
            for (int c = 0; c < 3; ++c)
                surface.box.add(boundaries.mesh.positions[boundaries.mesh.corners[member][c]]);
        out.push_back(std::move(surface));
    }
    return out;
}

void mark_overlaps(std::vector<Surface>& surfaces)
{
    std::sort(surfaces.begin(), surfaces.end(),
              [](const Surface& a, const Surface& b) { return a.box.low.x < b.box.low.x; });
    for (std::size_t i = 0; i < surfaces.size(); ++i)
        for (std::size_t j = i + 1;
             j < surfaces.size() && surfaces[j].box.low.x <= surfaces[i].box.high.x; ++j) {
            const Bounds<glm::vec3>&a = surfaces[i].box, &b = surfaces[j].box;
            if (glm::all(glm::lessThanEqual(a.low, b.high)) &&
                glm::all(glm::lessThanEqual(b.low, a.high)))
                surfaces[i].meets_another = surfaces[j].meets_another = true;
        }
}

/// A dielectric that the front of a face lies in, as a face of it; kNone: it lies in none.
/// direction: into the hemisphere of the front.
FaceId around_front(const TriangleMesh& mesh, const EmbreeScene& rays, FaceId face,
                    const glm::vec3& direction)
{
    SurfacePoint at = surface_point(mesh, face, glm::vec2(1.0f / 3));
    Ray ray;
    ray.direction = direction;
    int entered = 0;
    for (int faces = 0; faces < kMostFaces; ++faces) {
        ray.origin = offset_origin(at, ray.direction);
        const std::optional<RayHit> hit = rays.nearest(ray);
        if (!hit)
            break;
        at = surface_point(mesh, hit->face, hit->barycentric);
        entered += glm::dot(ray.direction, at.geometric_normal) <= 0 ? 1 : -1;
        if (entered < 0)
            return hit->face;
    }
    return kNone;
}

/// Two directions must agree, as a ray may slip through where faces meet.
FaceId around_front(const TriangleMesh& mesh, const EmbreeScene& rays, FaceId face)
{
    const glm::vec3 normal(glm::normalize(scaled_normal(mesh, face)));
    FaceId found = kNone;
    for (glm::vec3 direction :
         {glm::vec3(0.2371f, 0.8963f, 0.3747f), glm::vec3(-0.6413f, 0.3119f, 0.7010f)}) {
        direction = glm::normalize(direction);
        found = around_front(mesh, rays, face,
                             glm::dot(direction, normal) < 0 ? -direction : direction);
        if (found == kNone)
            return kNone;
    }
    return found;
}

} // namespace

std::vector<std::uint8_t> nested_dielectrics(const Scene& scene, const Partition& partition)
{
    std::vector<std::uint8_t> out(scene.materials.size(), 0);
    const Boundaries boundaries = collect(scene, partition);
    std::vector<Surface> surfaces = connected_surfaces(boundaries, partition);
    mark_overlaps(surfaces);
    std::vector<FaceId> asked;
    for (const Surface& surface : surfaces)
        if (surface.meets_another)
            asked.insert(asked.end(), surface.members.begin(), surface.members.end());
    if (asked.empty())
        return out;
    const EmbreeScene rays(boundaries.mesh);
    std::vector<FaceId> around(asked.size(), kNone);
    tbb::parallel_for(std::size_t{0}, asked.size(), [&](std::size_t i) {
        around[i] = around_front(boundaries.mesh, rays, asked[i]);
    });
    const auto material_of = [&](FaceId boundary) {
        return scene.mesh.material_of(boundaries.faces[boundary]);
    };
    for (std::size_t i = 0; i < asked.size(); ++i)
        if (around[i] != kNone)
            out[material_of(asked[i])] = out[material_of(around[i])] = 1;
    return out;
}

} // namespace hipmap
