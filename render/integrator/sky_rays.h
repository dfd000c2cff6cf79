#pragma once

#include "common/math/frame.h"
#include "common/math/sampling.h"
#include "render/photons/photon.h"
#include "render/shading/render_scene.h"

namespace hipmap {

/// Returns a ray from an importon by the cosine about its normal.
inline Ray ray_by_cosine(const Photon& importon, RandomSequence& random)
{
    const SurfacePoint from = {.face = importon.face,
                               .position = importon.position,
                               .geometric_normal = importon.direction};
    return ray_from(from,
                    Frame(importon.direction).to_world(sample_cosine_hemisphere(random.next2())));
}

/// Draws rays from an importon to look for the environments with: `count` by the cosine about its
/// normal, and as many by each environment's own samples, in turn.  visit: (ray) -> void; called in
/// order, may draw from `random` too.
template <typename Visit>
void draw_sky_rays(const RenderScene& scene, const Photon& importon, int count,
                   RandomSequence& random, const Visit& visit)
{
    const glm::vec3& normal = importon.direction;
    const SurfacePoint from = {
        .face = importon.face, .position = importon.position, .geometric_normal = normal};
    for (int i = 0; i < count; ++i) {
        visit(ray_by_cosine(importon, random));
        for (const std::uint32_t environment : scene.lights.environments)
            if (const std::optional<LightSample> drawn = sample_li(
                    scene.lights.lights[environment], {importon.position, normal}, random))
                visit(ray_from(from, drawn->direction));
    }
}

} // namespace hipmap
