#include "render/integrator/path_tracer.h"

#include "render/integrator/direct_light.h"
#include "render/integrator/media_path.h"
#include "render/shading/interface_index.h"

namespace hipmap {

namespace {

/// Adds the lamps between the path and what its ray has hit, and takes what glass absorbs.
[[gnu::noinline]] void cross_air(const RenderScene& scene, const std::optional<RayHit>& hit,
                                 const LightClasses& light, Path& path, Rgb& radiance)
{
    if (path.sees_lights(light))
        radiance += path.weight *
                    met_lamps(scene, path.ray, distance_of(hit), path.absorption, path.source);
    if (hit)
        absorb(path.absorption, hit->distance, path.weight);
}

} // namespace

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
        if (!scene.is_clear())
            cross_air(scene, hit, light, path, radiance);
        if (!hit)
            return path.sees_lights(light)
                       ? radiance + path.weight * met_sky(scene, path.ray.direction, path.source)
                       : radiance;
        Interaction at = interact(scene, path.ray, *hit);
        find_index(scene, at, path.nanometres, path.weight, random);
        if (!pass_surface(scene, at, hit->distance, light, random, path, radiance))
            return radiance;
    }
    return radiance;
}

} // namespace hipmap
