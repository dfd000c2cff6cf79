#pragma once

#include "render/shading/interface_index.h"
#include "render/shading/scatter.h"

namespace hipmap {

/// Where a path goes, and through what: the same for paths from the eye and from lights.
struct PathRay {
    Ray ray;
    Rgb absorption{0.0f}; ///< of what the ray travels in, where there are no media
    MediumStack inside;   ///< what the ray travels in, where there are media
    float nanometres = 0; ///< of the light followed; 0: all
};

/// Returns the surface that a path has met.  The interaction borrows path.inside.  Thread-safe.
inline Interaction meet_face(const RenderScene& scene, const RayHit& hit, const PathRay& path)
{
    Interaction at = interact(scene, path.ray, hit);
    at.inside = scene.has_media() ? &path.inside : nullptr;
    return at;
}

/// Keeps `inside` where the ray of a path that has left a surface goes on behind it.
inline void enter_media(const RenderScene& scene, const Interaction& at, PathRay& path)
{
    if (scene.has_media() && glm::dot(path.ray.direction, at.normal) < 0)
        cross(*scene.media, at.point.face, at.front, path.inside);
}

/// Sends a path on by the mirror of a surface.
void leave_by_mirror(const RenderScene& scene, const Interaction& at, PathRay& path);

/// Sends a path on through clear glass.  eta: as in SpecularLobes.
void leave_through(const RenderScene& scene, const Interaction& at, float eta, PathRay& path);

/// Sends a path on along a direction drawn from gathered or followed lobes.
inline void leave_by_lobes(const RenderScene& scene, const Interaction& at,
                           const LobeSample& sample, Lobes lobes, PathRay& path)
{
    path.ray = scattered_ray(at, sample);
    if (lobes == Lobes::gathered)
        path.nanometres = 0; // light is of all wavelengths after it
    else if (sample.transmitted)
        path.absorption = absorption_behind(at);
    enter_media(scene, at, path);
}

/// The way of a path through media to the next surface.
struct MediaFlight {
    std::optional<RayHit> hit; ///< none: it has left the scene, or a medium has scattered it
    bool scattered = false;    ///< by a medium, at the new origin of the ray
};

/// Follows a path through media to the next surface, or to where one of them scatters it, drawn by
/// the free path: keeps `inside`, and multiplies `carried` (throughput or power) by the weight.
/// all_faces: stop also at faces that would let the ray pass.  passed: (medium, optical depth) ->
/// void, called for each segment with what is carried before it.  docs/media.md (4).  Thread-safe.
template <bool all_faces = false, typename Passed>
MediaFlight fly_through_media(const MediaSet& media, PathRay& path, Rgb& carried,
                              RandomSequence& random, const Passed& passed)
{
    glm::vec3 position(0.0f);
    const WalkEnd end =
        walk<all_faces>(media, path.ray, path.inside, [&](const MediumSegment& segment) {
            const Medium& medium = media.medium(segment.inside);
            const OpticalDepth depth =
                optical_depth_along(media.density(segment.inside), segment.ray);
            passed(medium, depth.total);
            const FreePath free_path = sample_free_path(medium, depth.total, carried, random);
            carried *= free_path.weight;
            position = segment.ray.origin +
                       distance_at(depth, free_path.optical_depth) * segment.ray.direction;
            return !free_path.scattered;
        });
    if (!end.stopped)
        return {end.hit};
    path.ray.origin = position;
    return {std::nullopt, true};
}

} // namespace hipmap
