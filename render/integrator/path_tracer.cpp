#include "render/integrator/path_tracer.h"

#include "render/integrator/direct_light.h"
#include "render/integrator/media_path.h"

namespace hipmap {

Rgb trace_path(const RenderScene& scene, const Ray& ray, RandomSequence& random,
               const LightClasses& light)
{
    if (scene.media)
        return trace_media_path(scene, ray, random, light);
    Rgb radiance(0.0f);
    Path path;
    path.ray = ray;
    path.source.eye = true;
    for (int depth = 0; survives(depth, path, random); ++depth) {
        const std::optional<RayHit> hit = scene.rays.nearest(path.ray);
        if (path.sees_lights(light))
            radiance += path.weight *
                        met_lamps(scene, path.ray, distance_of(hit), path.absorption, path.source);
        if (!hit)
            return path.sees_lights(light)
                       ? radiance + path.weight * met_sky(scene, path.ray.direction, path.source)
                       : radiance;
        path.weight *= transmittance(path.absorption, hit->distance);
        const Interaction at = interact(scene, path.ray, *hit);
        if (!pass_surface(scene, at, hit->distance, light, random, path, radiance))
            return radiance;
    }
    return radiance;
}

} // namespace hipmap
