#include "render/integrator/media_path.h"

#include "render/shading/interface_index.h"
#include "render/shading/scatter.h"

namespace hipmap {

namespace {

/// A point at which a medium scatters light.
struct Scattering {
    glm::vec3 position{0.0f};
    const Medium* medium = nullptr;
};

/// Follows the ray to the next surface or scattering; adds what the media on the way glow.
WalkEnd fly(const MediaSet& media, Interiors& inside, RandomSequence& random, Path& path,
            Scattering& scattering, Rgb& radiance)
{
    return walk(media, path.ray, inside, [&](const Stretch& stretch) {
        const Medium& medium = media.medium(stretch.inside);
        const Column column = column_along(media.density(stretch.inside), stretch.ray);
        radiance += path.weight * emitted_along(medium, column.whole);
        const Flight flight = sample_flight(medium, column.whole, path.weight, random);
        path.weight *= flight.weight;
        const float along = distance_at(column, flight.column);
        scattering = {stretch.ray.origin + along * stretch.ray.direction, &medium};
        return !flight.scattered;
    });
}

void scatter(const RenderScene& scene, const Scattering& scattering, const Interiors& inside,
             RandomSequence& random, Path& path, Rgb& radiance)
{
    const Interaction at = scattering_point(scattering.position, -path.ray.direction,
                                            scattering.medium->phase, inside);
    radiance += path.weight * sampled_light(scene, at, {.gathered = 1}, random);
    const ScatterSample sample = sample_scatter(at, Lobes::gathered, random);
    path.weight *= sample.weight;
    path.source = source_at(at, sample.density);
    path.gathers = path.straight = true;
    path.nanometres = 0;
    path.ray = scattered_ray(at, sample);
}

} // namespace

Rgb trace_media_path(const RenderScene& scene, const Ray& ray, RandomSequence& random,
                     const LightClasses& light)
{
    const MediaSet& media = *scene.media;
    Rgb radiance(0.0f);
    Path path;
    path.ray = ray;
    path.source.eye = true;
    Interiors inside = interiors_at(media, ray.origin);
    for (int depth = 0; survives(depth, path, random); ++depth) {
        if (path.sees_lights(light))
            radiance += path.weight * met_lamps_in_media(scene, path.ray, inside, path.source);
        Scattering scattering;
        const WalkEnd end = fly(media, inside, random, path, scattering, radiance);
        if (end.stopped) {
            scatter(scene, scattering, inside, random, path, radiance);
            continue;
        }
        if (!end.hit)
            return path.sees_lights(light)
                       ? radiance + path.weight * met_sky(scene, path.ray.direction, path.source)
                       : radiance;
        Interaction at = interact(scene, path.ray, *end.hit);
        at.inside = &inside;
        find_index(scene, at, path.nanometres, path.weight, random);
        if (!pass_surface(scene, at, end.hit->distance, light, random, path, radiance))
            return radiance;
        if (glm::dot(path.ray.direction, at.normal) < 0)
            cross(media, end.hit->face, at.front, inside);
    }
    return radiance;
}

} // namespace hipmap
