#include "render/paths/direct_light.h"

#include "render/shading/lamps.h"
#include "render/shading/scatter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hipmap {

namespace {

/// Shadow rays towards those punctual lights that a tree chooses from.
constexpr int kChosenLamps = 4;

/// A light sample in both sets of lobes.
struct InLobes {
    Scattered gathered, followed;
};

/// Of light found with density `own`, weighed against another way that finds it with `other`: the
/// power heuristic.  The balance heuristic would let the odd ray of a matt lobe that runs into a
/// small lamp count for as much as all samples of the lamp.  own > 0.
float power_heuristic(float own, float other)
{
    const float ratio = other / own;
    return 1 / (1 + ratio * ratio);
}

InLobes in_lobes(const Interaction& at, const glm::vec3& direction, const LobeRays& rays)
{
    InLobes out;
    if (rays.gathered > 0)
        out.gathered = scattered(at, direction, Lobes::gathered);
    if (rays.followed > 0)
        out.followed = scattered(at, direction, Lobes::followed);
    return out;
}

/// What the lobes send of the light found with `density` in a direction.
Rgb weighed(const InLobes& lobes, const LobeRays& rays, float density)
{
    return lobes.gathered.value * power_heuristic(density, rays.gathered * lobes.gathered.density) +
           lobes.followed.value * power_heuristic(density, rays.followed * lobes.followed.density);
}

/// chosen: how many samples of it there are, on average.
Rgb from_lamp(const RenderScene& scene, const Interaction& at, std::uint32_t lamp, double chosen,
              const LobeRays& rays, RandomSequence& random)
{
    const bool sized = has_size(scene.lights, lamp);
    const std::optional<LampSample> sample =
        sample_lamp(scene.lights, lamp, at.point.position, sized ? random.next2() : glm::vec2(0));
    if (!sample)
        return Rgb(0);
    Ray shadow;
    if (sample->is_far) {
        shadow.direction = sample->direction;
        shadow.origin = offset_origin(at.point, shadow.direction);
    } else {
        shadow = ray_between(at.point, sample->point);
    }
    const InLobes lobes = in_lobes(at, shadow.direction, rays);
    const Rgb value = sample->density > 0
                          ? weighed(lobes, rays, static_cast<float>(chosen * sample->density))
                          : lobes.gathered.value + lobes.followed.value;
    const Rgb sent = value * sample->light / static_cast<float>(chosen);
    return is_black(sent) ? sent : sent * unoccluded(scene, at, shadow);
}

/// Rough glass, and what passes light diffusely, takes light from both sides.
LightReceiver receiver(const Interaction& at)
{
    const bool both = at.bsdf().transmits || at.bsdf().transmits_diffusely;
    return {at.point.position, both ? glm::vec3(0) : at.normal};
}

/// Chance per solid angle that sampling the emissive faces finds a point, of that per area.
float per_solid_angle(float density, const SurfacePoint& on_light, const glm::vec3& direction,
                      float distance)
{
    const float cosine = std::abs(glm::dot(direction, on_light.geometric_normal));
    return cosine > 0 ? density * distance * distance / cosine : 0;
}

/// The lamps with a size along a ray; `left(distance)` is what is left of light from there.
template <typename Left>
Rgb add_lamps(const RenderScene& scene, const Ray& ray, float distance, const RaySource& source,
              const Left& left)
{
    const LightSet& lights = scene.lights;
    Rgb sum(0.0f);
    if (source.eye || !has_sized_lamps(lights))
        return sum;
    const auto add = [&](std::uint32_t lamp, const auto& chosen) {
        const std::optional<LampHit> hit = meet_lamp(lights, lamp, ray);
        if (!hit || !(hit->distance <= distance))
            return;
        Rgb part = hit->radiance;
        if (source.density > 0)
            part *= power_heuristic(source.density, chosen() * hit->density);
        sum += part * left(hit->distance);
    };
    for (const std::uint32_t lamp : lights.sized_lamps)
        add(lamp, [] { return 1.0f; });
    if (lights.chosen_have_size)
        over_lights_along(lights.lamp_tree, ray.origin, ray.direction, [&](std::uint32_t place) {
            add(lights.chosen_lamps[place], [&] {
                return static_cast<float>(kChosenLamps *
                                          chance_of(lights.lamp_tree, source.at, place));
            });
        });
    return sum;
}

} // namespace

float distance_of(const std::optional<RayHit>& hit)
{
    return hit ? hit->distance : std::numeric_limits<float>::infinity();
}

RaySource source_at(const Interaction& at, float density)
{
    return {receiver(at), density};
}

float hit_weight(const RenderScene& scene, const SurfacePoint& on_light, const glm::vec3& direction,
                 float distance, const RaySource& source)
{
    if (source.density == 0 || scene.lights.density.empty())
        return 1;
    const float density = emissive_density(scene.lights, scene.mesh(), source.at, on_light.face);
    return power_heuristic(source.density, per_solid_angle(density, on_light, direction, distance));
}

Rgb lamps_on_way(const RenderScene& scene, const Ray& ray, float distance, const Rgb& absorption,
                 const RaySource& source)
{
    return add_lamps(scene, ray, distance, source,
                     [&](float to_lamp) { return transmittance(absorption, to_lamp); });
}

Rgb met_lamps_in_media(const RenderScene& scene, const Ray& ray, const Interiors& inside,
                       const RaySource& source)
{
    return add_lamps(scene, ray, std::numeric_limits<float>::infinity(), source,
                     [&](float to_lamp) {
                         Ray way = ray;
                         way.far = to_lamp;
                         return let_through(*scene.media, way, inside);
                     });
}

Rgb met_sky(const RenderScene& scene, const glm::vec3& direction, const RaySource& source)
{
    const LightSet& lights = scene.lights;
    const Rgb radiance = sky_radiance(lights, direction);
    if (!has_sky_picture(lights) || source.density == 0)
        return radiance;
    return radiance * power_heuristic(source.density, sky_density(lights.sky, direction));
}

Rgb sky_light(const RenderScene& scene, const Interaction& at, const LobeRays& rays,
              RandomSequence& random)
{
    const SkyPicture& sky = scene.lights.sky;
    if (sky.empty())
        return Rgb(0);
    Ray shadow;
    shadow.direction = sample_sky(sky, random.next2());
    shadow.origin = offset_origin(at.point, shadow.direction);
    const float density = sky_density(sky, shadow.direction);
    if (!(density > 0))
        return Rgb(0);
    const Rgb sent = weighed(in_lobes(at, shadow.direction, rays), rays, density) *
                     sky_radiance(sky, shadow.direction) / density;
    return is_black(sent) ? sent : sent * unoccluded(scene, at, shadow);
}

Rgb lamp_light(const RenderScene& scene, const Interaction& at, const LobeRays& rays,
               RandomSequence& random)
{
    const LightSet& lights = scene.lights;
    Rgb sum(0.0f);
    for (const std::uint32_t lamp : lights.other_lamps)
        sum += from_lamp(scene, at, lamp, 1, rays, random);
    if (lights.lamp_tree.empty())
        return sum;
    const LightReceiver from = receiver(at);
    for (int i = 0; i < kChosenLamps; ++i) {
        const double u = (i + double{random.next()}) / kChosenLamps;
        if (const std::optional<ChosenLight> chosen = choose_light(lights.lamp_tree, from, u))
            sum += from_lamp(scene, at, lights.chosen_lamps[chosen->light],
                             kChosenLamps * chosen->chance, rays, random);
    }
    return sum;
}

Rgb emissive_light(const RenderScene& scene, const Interaction& at, const LobeRays& rays,
                   RandomSequence& random)
{
    if (scene.lights.emissive_faces.empty())
        return Rgb(0);
    const EmissivePoint light =
        sample_emissive_point(scene.lights, scene.mesh(), receiver(at), random);
    if (!(light.density > 0))
        return Rgb(0);
    const Ray shadow = ray_between(at.point, light.surface);
    const float distance = glm::length(light.surface.position - at.point.position);
    const float density = per_solid_angle(light.density, light.surface, shadow.direction, distance);
    if (!(density > 0))
        return Rgb(0);
    const Rgb sent = weighed(in_lobes(at, shadow.direction, rays), rays, density);
    const Rgb out = sent / density * light_radiance(scene, light, -shadow.direction);
    return is_black(out) ? out : out * unoccluded(scene, at, shadow);
}

Rgb found_light(const RenderScene& scene, const Interaction& at, RandomSequence& random)
{
    if (!can_be_met(scene.lights))
        return Rgb(0);
    const ScatterSample sample = sample_scatter(at, Lobes::gathered, random);
    if (is_black(sample.weight))
        return Rgb(0);
    const Ray ray = scattered_ray(at, sample);
    const RaySource source = source_at(at, sample.density);
    Rgb weight = sample.weight;
    const std::optional<RayHit> hit = first_surface(scene, at, ray, weight);
    const Interiors inside = interiors_towards(scene, at, ray.direction);
    const Rgb lamps =
        sample.weight * (!at.in_media() ? met_lamps(scene, ray, distance_of(hit), Rgb(0), source)
                                        : met_lamps_in_media(scene, ray, inside, source));
    if (!hit)
        return lamps + weight * met_sky(scene, ray.direction, source);
    const Bsdf& bsdf = scene.bsdfs[scene.mesh().material_of_face[hit->face]];
    if (is_black(bsdf.emission))
        return lamps;
    const SurfacePoint light = surface_point(scene.mesh(), hit->face, hit->barycentric);
    if (!shines_towards(bsdf, light, -ray.direction))
        return lamps;
    return lamps + weight * emission_at(scene, hit->face, hit->barycentric) *
                       hit_weight(scene, light, ray.direction, hit->distance, source);
}

Rgb light_of_all_kinds(const RenderScene& scene, const Interaction& at, const LobeRays& rays,
                       RandomSequence& random)
{
    Rgb sum = lamp_light(scene, at, rays, random) + emissive_light(scene, at, rays, random);
    if (has_sky_picture(scene.lights))
        sum += sky_light(scene, at, rays, random);
    return sum;
}

} // namespace hipmap
