#pragma once

#include "common/math/frame.h"
#include "common/math/sampling.h"
#include "render/photons/photon.h"
#include "render/shading/render_scene.h"

namespace hipmap {

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
        visit(ray_from(from, Frame(normal).to_world(sample_cosine_hemisphere(random.next2()))));
        for (const std::uint32_t environment : scene.lights.environments)
            if (const std::optional<LightSample> drawn = sample_li(
                    scene.lights.lights[environment], {importon.position, normal}, random))
                visit(ray_from(from, drawn->direction));
    }
}

} // namespace hipmap
