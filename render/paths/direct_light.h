#pragma once

#include "common/math/random.h"
#include "render/paths/direction_guide.h"
#include "render/shading/interaction.h"

namespace hipmap {

/// The probability with which each set of lobes sends a ray of its own at a surface, which may find
/// the lights too; 0: the set is left out of the light sampled.
struct LobeRays {
    float gathered = 0.0f;
    float followed = 0.0f;
    const DirectionGuide* guide = nullptr; ///< of the gathered rays; null: their lobes alone
    const DirectionGuide* sky = nullptr;   ///< by which environments have a sample; null: none
    int points = 1;                        ///< sampled on emissive faces
};

/// The start of a ray and the pdf of its direction.
struct RaySource {
    LightReceiver at;
    float pdf = 0.0f; ///< pdf per solid angle with which lobes sent it; 0: a mirror, glass or
                      ///<   the eye did, and sampling the lights could not have found its light
    const DirectionGuide* sky = nullptr; ///< by which environments were sampled there; null: not
    int points = 1;                      ///< sampled on emissive faces there
    bool eye = false; ///< it comes straight from the eye, which does not see analytic lights
    /// How many photons find light of unit radiance that the ray meets, for each such ray: where
    /// specular surfaces (pdf 0) lie between it and a followed lobe, docs/light_transport.md (44).
    Rgb photons{0.0f};
};

/// Returns the ray from a point to where sampled light comes from; it stops short of the light.
inline Ray shadow_ray(const SurfacePoint& from, const LightSample& sample)
{
    return sample.is_far ? ray_from(from, sample.direction) : ray_between(from, sample.point);
}

/// Returns the length of a ray: infinite if it hits nothing.
float distance_of(const std::optional<RayHit>& hit);

/// Returns the source of a ray that lobes of the surface sent.  pdf: per solid angle.
RaySource source_at(const Interaction& at, float pdf);

/// Returns the weight of light that a ray found by meeting a light at `distance`; light-sampled
/// light has the rest (power heuristic, Veach 1997).  direction: of the ray.
float hit_weight(const RenderScene& scene, const SurfacePoint& on_light, const glm::vec3& direction,
                 float distance, const RaySource& source);

/// Returns the weight of radiance that the ray of specular surfaces met, against photons.
inline float weight_against_photons(const Rgb& radiance, const RaySource& source)
{
    return source.pdf > 0 ? 1.0f : 1 / (1 + max_channel(source.photons * radiance));
}

/// Implements `met_lights` where rays can meet analytic lights.
Rgb lights_on_way(const RenderScene& scene, const Ray& ray, float distance, const Rgb& absorption,
                  const RaySource& source);

/// Returns the radiance along a ray of the analytic lights within `distance`; infinite: it leaves
/// the scene and may meet suns.  Each light is weighted by `hit_weight`.  These lights hide
/// nothing.  absorption: of what the ray travels in.
inline Rgb met_lights(const RenderScene& scene, const Ray& ray, float distance,
                      const Rgb& absorption, const RaySource& source)
{
    return has_met_lights(scene.lights) && !source.eye
               ? lights_on_way(scene, ray, distance, absorption, source)
               : Rgb(0);
}

/// Returns `met_lights` through the media of the scene, which must have some, up to the first
/// surface.  inside: the media at the start of the ray.
Rgb met_lights_in_media(const RenderScene& scene, const Ray& ray, const MediumStack& inside,
                        const RaySource& source);

/// Returns the radiance of the environment along a ray that leaves the scene, weighted by
/// `hit_weight`.
Rgb met_environment(const RenderScene& scene, const glm::vec3& direction, const RaySource& source);

/// Returns the radiance towards `at.back` of direct light from the emissive faces, by points on
/// them, weighted by the power heuristic against the rays of the lobes.  Zero if there are none.
Rgb emissive_light(const RenderScene& scene, const Interaction& at, const LobeRays& rays,
                   RandomSequence& random);

/// Returns the radiance towards `at.back` of direct light in a scene with any kinds of lights.
Rgb light_of_all_kinds(const RenderScene& scene, const Interaction& at, const LobeRays& rays,
                       RandomSequence& random);

/// Returns light-sampled light (next-event estimation): the radiance towards `at.back` of direct
/// light from all lights, or a sample of them.  Together with the light that rays of the lobes
/// find, weighted by `hit_weight`, `met_lights` and `met_environment`, it is all direct light,
/// docs/light_transport.md (11).  Thread-safe.
inline Rgb light_sampled_light(const RenderScene& scene, const Interaction& at,
                               const LobeRays& rays, RandomSequence& random)
{
    return scene.lit_by_faces ? emissive_light(scene, at, rays, random)
                              : light_of_all_kinds(scene, at, rays, random);
}

/// Returns BSDF-sampled light: the direct light that one ray drawn from the gathered lobes finds.
/// Added to `light_sampled_light` by the same `rays` at gathered = 1 and no guide, it is an
/// unbiased estimate of all direct light in these lobes.
Rgb bsdf_sampled_light(const RenderScene& scene, const Interaction& at, const LobeRays& rays,
                       RandomSequence& random);

} // namespace hipmap
