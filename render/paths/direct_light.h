#pragma once

#include "common/math/random.h"
#include "render/shading/interaction.h"

namespace hipmap {

/// The chance with which each set of lobes sends a ray of its own at a surface, which may find the
/// lights too; 0: the set is left out of the light sampled.
struct LobeRays {
    float gathered = 0.0f;
    float followed = 0.0f;
};

/// Where a ray comes from.
struct RaySource {
    LightReceiver at;
    float density = 0.0f; ///< chance per solid angle that lobes sent it; 0: a mirror, glass or the
                          ///<   eye did, and sampling the lights could not have found its light
    bool eye = false;     ///< it comes straight from the eye, which does not see lamps
};

/// How far a ray goes: infinitely if it hits nothing.
float distance_of(const std::optional<RayHit>& hit);

/// Of a ray that lobes of the surface sent.
RaySource source_at(const Interaction& at, float density);

/// The part of the light from `on_light` that counts for a ray that ran into it at `distance`, the
/// rest being that of `emissive_light` (power heuristic, Veach 1997).  direction: of the ray.
float hit_weight(const RenderScene& scene, const SurfacePoint& on_light, const glm::vec3& direction,
                 float distance, const RaySource& source);

/// `met_lamps` where there are lamps with a size, of a ray that is not the eye's.
Rgb lamps_on_way(const RenderScene& scene, const Ray& ray, float distance, const Rgb& absorption,
                 const RaySource& source);

/// Radiance along a ray from the lamps with a size that lie on its way of `distance`; infinite: it
/// leaves the scene and may run into suns.  Each counts as `hit_weight` has it.  Lamps hide
/// nothing. absorption: of what the ray travels in.
inline Rgb met_lamps(const RenderScene& scene, const Ray& ray, float distance,
                     const Rgb& absorption, const RaySource& source)
{
    return has_sized_lamps(scene.lights) && !source.eye
               ? lamps_on_way(scene, ray, distance, absorption, source)
               : Rgb(0);
}

/// The same through the media of the scene, which must have some, until a surface hides the lamps.
/// inside: what the ray starts in.
Rgb met_lamps_in_media(const RenderScene& scene, const Ray& ray, const Interiors& inside,
                       const RaySource& source);

/// Radiance of the sky along a ray that leaves the scene, counted as `hit_weight` has it.
Rgb met_sky(const RenderScene& scene, const glm::vec3& direction, const RaySource& source);

/// Radiance towards `at.back` of light straight from lamps: all of them, or all suns and some of
/// the others, chosen by a tree; those with a size weighed against the rays of the lobes.
Rgb lamp_light(const RenderScene& scene, const Interaction& at, const LobeRays& rays,
               RandomSequence& random);

/// The same from the emissive faces by one point on them, weighed by the power heuristic against
/// the rays of the lobes.  Zero if there are none.
Rgb emissive_light(const RenderScene& scene, const Interaction& at, const LobeRays& rays,
                   RandomSequence& random);

/// The same from a picture of the sky.  Zero if it is uniform: rays of the lobes find that.
Rgb sky_light(const RenderScene& scene, const Interaction& at, const LobeRays& rays,
              RandomSequence& random);

/// From all of them.
Rgb light_of_all_kinds(const RenderScene& scene, const Interaction& at, const LobeRays& rays,
                       RandomSequence& random);

/// The same, where there may be emissive faces alone.  Light straight from the lights is this and
/// what the rays of the lobes find, by `hit_weight` and `met_lamps`, docs/light_transport.md (11).
/// Thread-safe.
inline Rgb sampled_light(const RenderScene& scene, const Interaction& at, const LobeRays& rays,
                         RandomSequence& random)
{
    return scene.is_lit_by_faces() ? emissive_light(scene, at, rays, random)
                                   : light_of_all_kinds(scene, at, rays, random);
}

/// What the one ray that the gathered lobes send finds of emissive faces and sky: with
/// `sampled_light` at {.gathered = 1}, an unbiased estimate of all direct light in these lobes.
Rgb found_light(const RenderScene& scene, const Interaction& at, RandomSequence& random);

} // namespace hipmap
