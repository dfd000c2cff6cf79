#pragma once

#include "common/math/frame.h"
#include "common/math/sampling.h"
#include "render/photons/photon.h"
#include "render/shading/render_scene.h"

namespace hipmap {

/// Returns the ray from an importon in a direction.
inline Ray ray_from_importon(const Photon& importon, const glm::vec3& direction)
{
    return ray_from({.face = importon.face,
                     .position = importon.position,
                     .geometric_normal = importon.direction},
                    direction);
}

/// Returns a ray from an importon by the cosine about its normal.
inline Ray ray_by_cosine(const Photon& importon, RandomSequence& random)
{
    return ray_from_importon(
        importon, Frame(importon.direction).to_world(sample_cosine_hemisphere(random.next2())));
}

/// Draws rays from an importon to look for the environments with: `count` by the cosine about its
/// normal, and as many by each environment's own samples, in turn.  visit: (ray) -> void; called in
/// order, may draw from `random` too.
template <typename Visit>
void draw_sky_rays(const RenderScene& scene, const Photon& importon, int count,
                   RandomSequence& random, const Visit& visit)
{
    for (int i = 0; i < count; ++i) {
        visit(ray_by_cosine(importon, random));
        for (const std::uint32_t environment : scene.lights.environments)
            if (const std::optional<LightSample> drawn =
                    sample_li(scene.lights.lights[environment],
                              {importon.position, importon.direction}, random))
                visit(ray_from_importon(importon, drawn->direction));
    }
}

} // namespace hipmap
