#pragma once

#include "common/math/random.h"
#include "render/shading/interaction.h"

namespace hipmap {

/// The probability with which each set of lobes sends a ray of its own at a surface, which may find
/// the lights too; 0: the set is left out of the light sampled.
struct LobeRays {
    float gathered = 0.0f;
    float followed = 0.0f;
};

/// Where a ray comes from.
struct RaySource {
    LightReceiver at;
    float pdf = 0.0f; ///< pdf per solid angle with which lobes sent it; 0: a mirror, glass or
                      ///<   the eye did, and sampling the lights could not have found its light
    bool eye = false; ///< it comes straight from the eye, which does not see analytic lights
};

/// How far a ray goes: infinitely if it hits nothing.
float distance_of(const std::optional<RayHit>& hit);

/// Of a ray that lobes of the surface sent.
RaySource source_at(const Interaction& at, float pdf);

/// The part of the light from `on_light` that counts for a ray that ran into it at `distance`, the
/// rest being that of `emissive_light` (power heuristic, Veach 1997).  direction: of the ray.
float hit_weight(const RenderScene& scene, const SurfacePoint& on_light, const glm::vec3& direction,
                 float distance, const RaySource& source);

/// `met_lights` where rays can run into analytic lights.
Rgb lights_on_way(const RenderScene& scene, const Ray& ray, float distance, const Rgb& absorption,
                  const RaySource& source);

/// Radiance along a ray from the analytic lights that lie on its way of `distance`; infinite: it
/// leaves the scene and may run into suns.  Each counts as `hit_weight` has it.  These lights hide
/// nothing.  absorption: of what the ray travels in.
inline Rgb met_lights(const RenderScene& scene, const Ray& ray, float distance,
                      const Rgb& absorption, const RaySource& source)
{
    return has_met_lights(scene.lights) && !source.eye
               ? lights_on_way(scene, ray, distance, absorption, source)
               : Rgb(0);
}

/// `met_lights` through the media of the scene, which must have some, until a surface hides the
/// lights.  inside: what the ray starts in.
Rgb met_lights_in_media(const RenderScene& scene, const Ray& ray, const MediumStack& inside,
                        const RaySource& source);

/// Radiance of the environment along a ray that leaves the scene, counted as `hit_weight` has it.
Rgb met_environment(const RenderScene& scene, const glm::vec3& direction, const RaySource& source);

/// Radiance towards `at.back` of light straight from the emissive faces, by one point on them,
/// weighed by the power heuristic against the rays of the lobes.  Zero if there are none.
Rgb emissive_light(const RenderScene& scene, const Interaction& at, const LobeRays& rays,
                   RandomSequence& random);

/// Radiance towards `at.back` of light straight from the lights of a scene with any kinds of them.
Rgb light_of_all_kinds(const RenderScene& scene, const Interaction& at, const LobeRays& rays,
                       RandomSequence& random);

/// Radiance towards `at.back` of light straight from the lights, all or some of them sampled.  With
/// what the rays of the lobes find, by `hit_weight`, `met_lights` and `met_environment`, it is all
/// direct light, docs/light_transport.md (11).  Thread-safe.
inline Rgb light_sampled_light(const RenderScene& scene, const Interaction& at,
                               const LobeRays& rays, RandomSequence& random)
{
    return scene.is_lit_by_faces() ? emissive_light(scene, at, rays, random)
                                   : light_of_all_kinds(scene, at, rays, random);
}

/// What the one ray that the gathered lobes send finds of lights: with
/// `light_sampled_light` at {.gathered = 1}, an unbiased estimate of all direct light in these
/// lobes.
Rgb bsdf_sampled_light(const RenderScene& scene, const Interaction& at, RandomSequence& random);

} // namespace hipmap
