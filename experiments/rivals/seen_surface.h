#pragma once

#include "render/paths/path_state.h"

namespace hipmap {

/// Sends an eye path on by one of the lobes of a surface that are not gathered; no throughput is
/// left where there are none.  Adds the light sampled for the followed ones to `radiance`.
void leave_unless_gathered(const RenderScene& scene, const Interaction& at, RandomSequence& random,
                           PathState& path, Rgb& radiance);

/// Returns the radiance along an eye ray in a scene without media: lights seen directly, over
/// mirrors, glass and glossy lobes, and what `shade` returns for each surface that such a path
/// meets. shade(at, hit, random) -> radiance towards at.back by the gathered lobes.  These are
/// Whitted's rays (1980), and the second pass of all methods that store light on surfaces.
template <typename Shade>
Rgb see_surfaces(const RenderScene& scene, const Ray& ray, RandomSequence& random,
                 const Shade& shade)
{
    PathState path = path_from_eye(scene, ray);
    Rgb radiance(0.0f);
    while (survives(path, random)) {
        const MediaFlight reached =
            reach(scene, path, true, radiance, [] { return MediaFlight{}; });
        if (!reached.hit)
            break;
        const Interaction at = meet(scene, *reached.hit, random, path);
        radiance += met_emission(scene, at, reached.hit->distance, path);
        if (at.gathers())
            radiance += path.throughput * shade(at, *reached.hit, random);
        leave_unless_gathered(scene, at, random, path, radiance);
    }
    return radiance;
}

/// Returns direct light towards at.back by the gathered lobes.
inline Rgb direct_light(const RenderScene& scene, const Interaction& at, RandomSequence& random)
{
    return light_sampled_light(scene, at, {.gathered = 1}, random) +
           bsdf_sampled_light(scene, at, {.gathered = 1}, random);
}

/// Returns the connected surface's side that a ray meets a face on: Interaction::side.
inline std::uint8_t side_of(const RenderScene& scene, FaceId face, bool front)
{
    return front == scene.partition.is_flipped(face) ? 1 : 0;
}

} // namespace hipmap
