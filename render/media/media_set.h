#pragma once

#include "common/partition/partition.h"
#include "common/rays/embree_scene.h"
#include "common/rays/surface_point.h"
#include "common/scene/scene.h"
#include "render/media/free_path.h"
#include "render/media/medium_stack.h"
#include "render/media/optical_depth.h"

#include <cmath>
#include <optional>
#include <vector>

namespace hipmap {

/// The media of a scene, docs/media.md.  Borrows the scene, its partition and its rays.
/// Read-only: any number of threads may use it.
struct MediaSet {
    const TriangleMesh& mesh;
    const Partition& partition;
    const EmbreeScene& rays;
    std::vector<Medium> insides{};           ///< [M]
    std::vector<std::uint8_t> has_inside{};  ///< [M] 1: light gets into closed meshes of it
    std::vector<std::uint8_t> has_surface{}; ///< [M] 0: rays go on through its faces
    std::vector<std::uint8_t> bends{};       ///< [M] 1: its surface is that of a dielectric
    std::vector<float> priority{};           ///< [M]
    Medium around{};                         ///< within the sphere around all faces
    glm::vec3 centre{0.0f};
    float radius = 0.0f;
    glm::vec3 low{0.0f}, high{0.0f}; ///< box of the faces that have an inside; low > high: none
    bool nested = false;             ///< dielectrics lie in one another
    bool scatters = false;           ///< any of them
    bool emits = false;
    Rgb emission_power{0.0f};               ///< about, W / metres_per_unit^2
    std::vector<PlacedDensity> densities{}; ///< [M + 1] of the insides, and last of `around`

    const Medium& medium(MaterialId inside) const
    {
        return inside == kNone ? around : insides[inside];
    }
    const PlacedDensity& density(MaterialId inside) const
    {
        return inside == kNone ? densities.back() : densities[inside];
    }
};

/// Collects the media of a scene.  Returns nothing if no medium scatters, emits or surrounds the
/// scene, every material has a surface, dielectrics do not overlap, and neither the camera nor a
/// light stands in glass that absorbs: then the only medium may be such glass, which every path
/// enters through its surface.
std::optional<MediaSet> collect_media(const Scene& scene, const Partition& partition,
                                      const EmbreeScene& rays);

inline bool has_surface(const MediaSet& media, FaceId face)
{
    return media.has_surface[media.mesh.material_of(face)] != 0;
}

/// Updates `inside` for a ray that crosses a face.  front: from its front to its back.
void cross(const MediaSet& media, FaceId face, bool front, MediumStack& inside);

/// Returns the dielectric whose index of refraction applies in `inside`; kNone: there is none, the
/// index is 1.
MaterialId dielectric_at(const MediaSet& media, const MediumStack& inside);

/// Returns whether a ray in `inside` meets a surface at a face.  It does not where the material has
/// no surface, nor where a dielectric begins or ends within one of a higher priority, docs/media.md
/// (12).
bool is_surface(const MediaSet& media, FaceId face, bool front, const MediumStack& inside);

/// Returns the media around a point, from the faces met on the way out.  Cost: some rays where it
/// lies in the box of faces that have an inside, else none.
MediumStack medium_stack_at(const MediaSet& media, const glm::vec3& point);

/// A light path that starts in an emissive medium.
struct MediaEmission {
    Ray ray;
    Rgb power{0.0f}; ///< W / metres_per_unit^2; black: the line drawn meets no such medium
};

/// Draws a line through the media, a point on it where they emit, and a direction along it,
/// docs/media.md (10).  The mean of the power is the power that they emit.  Cost: a ray for each
/// face on the line.
MediaEmission sample_media_emission(const MediaSet& media, RandomSequence& random);

/// Returns the mean power of a fixed set of these paths.
Rgb mean_media_emission(const MediaSet& media);

/// A part of a ray that lies in one medium.
struct MediumSegment {
    MaterialId inside = kNone; ///< kNone: around
    Ray ray;                   ///< the segment is its part from near to far, which is finite
    float before = 0.0f;       ///< from the start of the walk to the ray's origin
};

/// Returns the transmittance of a segment, docs/media.md (3).
inline Rgb left_along(const MediaSet& media, const MediumSegment& segment)
{
    return transmitted(media.medium(segment.inside).extinction(),
                       total_optical_depth(media.density(segment.inside), segment.ray));
}

/// The end of a walk through media.
struct WalkEnd {
    std::optional<RayHit> hit; ///< its distance is from the start of the walk
    bool stopped = false;      ///< by the visitor
};

/// The most boundaries without a surface that a ray crosses; the next one counts as opaque.
inline constexpr int kMostBoundaries = 256;

/// Returns the part of a ray in the sphere of the surrounding medium; none: near >= far.
Ray within_sphere(const MediaSet& media, const Ray& ray);

/// Follows a ray from boundary to boundary to the first face with a surface, or to its far end, and
/// calls `visit(segment)` for each segment of it that holds a medium; false stops the walk. inside:
/// the media at the start; at the end, those before the face. all_faces: stop also at faces that
/// would let the ray pass.
template <bool all_faces = false, typename Visit>
WalkEnd walk(const MediaSet& media, Ray ray, MediumStack& inside, const Visit& visit)
{
    float before = 0;
    for (int crossed = 0; ray.far > 0; ++crossed) {
        const std::optional<RayHit> hit =
            all_faces ? media.rays.nearest_face(ray) : media.rays.nearest(ray);
        const MaterialId current = inside.current();
        if (!media.medium(current).is_clear()) {
            MediumSegment segment{current, ray, before};
            segment.ray.far = hit ? hit->distance : ray.far;
            if (current == kNone)
                segment.ray = within_sphere(media, segment.ray);
            // An inside that never ends is that of a mesh which is not closed after all.
            if (segment.ray.near < segment.ray.far && std::isfinite(segment.ray.far) &&
                !visit(segment))
                return {std::nullopt, true};
        }
        if (!hit)
            return {};
        const WalkEnd end{RayHit{before + hit->distance, hit->face, hit->barycentric}, false};
        if (crossed == kMostBoundaries || (has_surface(media, hit->face) && !media.nested))
            return end;
        const SurfacePoint at = surface_point(media.mesh, hit->face, hit->barycentric);
        const bool front = glm::dot(ray.direction, at.geometric_normal) <= 0;
        if (is_surface(media, hit->face, front, inside))
            return end;
        cross(media, hit->face, front, inside);
        before += hit->distance;
        ray.origin = offset_origin(at, ray.direction);
        ray.near = Ray{}.near; // a camera's clipping plane lies behind
        ray.far -= hit->distance;
    }
    return {};
}

/// Returns the transmittance between two points: black if a face with a surface is between.
Rgb let_through(const MediaSet& media, const Ray& ray, MediumStack inside);

} // namespace hipmap
