#include "render/integrator/path_tracer.h"

#include "render/integrator/direct_light.h"
#include "render/integrator/media_path.h"
#include "render/shading/dispersion.h"

namespace hipmap {

Rgb trace_path(const RenderScene& scene, const Ray& ray, RandomSequence& random,
               const LightClasses& light)
{
    if (scene.has_media())
        return trace_media_path(scene, ray, random, light);
    Rgb radiance(0.0f);
    Path path;
    path.ray = ray;
    path.source.eye = true;
    for (int depth = 0; survives(depth, path, random); ++depth) {
        const std::optional<RayHit> hit = scene.rays.nearest(path.ray);
        if (has_sized_lamps(scene.lights) && path.sees_lights(light))
            radiance += path.weight *
                        met_lamps(scene, path.ray, distance_of(hit), path.absorption, path.source);
        if (!hit)
            return path.sees_lights(light)
                       ? radiance + path.weight * met_sky(scene, path.ray.direction, path.source)
                       : radiance;
        absorb(path.absorption, hit->distance, path.weight);
        Interaction at = interact(scene, path.ray, *hit);
        disperse(at, path.nanometres, path.weight, random);
        if (!pass_surface(scene, at, hit->distance, light, random, path, radiance))
            return radiance;
    }
    return radiance;
}

} // namespace hipmap
