#include "render/integrator/direct_light.h"

#include "render/shading/scatter.h"

#include <algorithm>
#include <cmath>

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

Rgb from_punctual(const RenderScene& scene, const Interaction& at, const PunctualLight& light,
                  const LobeRays& rays)
{
    Ray shadow;
    Rgb arriving;
    if (light.kind == LightKind::directional) {
        shadow.direction = -light.direction;
        shadow.origin = offset_origin(at.point, shadow.direction);
        arriving = light.intensity;
    } else {
        shadow = ray_between(at.point, light.position);
        const glm::vec3 way = light.position - at.point.position;
        const float distance2 = glm::dot(way, way);
        if (!(distance2 > 0))
            return Rgb(0);
        arriving = light_intensity(light, -shadow.direction) / distance2;
    }
    const InLobes lobes = in_lobes(at, shadow.direction, rays);
    const Rgb sent = (lobes.gathered.value + lobes.followed.value) * arriving;
    if (is_black(sent) || scene.rays.occluded(shadow))
        return Rgb(0);
    return sent;
}

/// Rough glass takes light from both sides.
LightReceiver receiver(const Interaction& at)
{
    return {at.point.position, at.bsdf.glass > 0 ? glm::vec3(0) : at.normal};
}

/// Chance per solid angle that sampling the emissive faces finds a point, of that per area.
float per_solid_angle(float density, const SurfacePoint& on_light, const glm::vec3& direction,
                      float distance)
{
    const float cosine = std::abs(glm::dot(direction, on_light.geometric_normal));
    return cosine > 0 ? density * distance * distance / cosine : 0;
}

} // namespace

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

Rgb punctual_light(const RenderScene& scene, const Interaction& at, const LobeRays& rays,
                   RandomSequence& random)
{
    const LightSet& lights = scene.lights;
    Rgb sum(0.0f);
    for (const std::uint32_t lamp : lights.other_lamps)
        sum += from_punctual(scene, at, lights.punctual[lamp], rays);
    if (lights.lamp_tree.empty())
        return sum;
    const LightReceiver from = receiver(at);
    for (int i = 0; i < kChosenLamps; ++i) {
        const double u = (i + double{random.next()}) / kChosenLamps;
        if (const std::optional<ChosenLight> chosen = choose_light(lights.lamp_tree, from, u))
            sum += from_punctual(scene, at, lights.punctual[lights.chosen_lamps[chosen->light]],
                                 rays) /
                   static_cast<float>(kChosenLamps * chosen->chance);
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
    const Ray shadow = ray_between(at.point, light.surface.position);
    const float distance = glm::length(light.surface.position - at.point.position);
    const float density = per_solid_angle(light.density, light.surface, shadow.direction, distance);
    if (!(density > 0))
        return Rgb(0);
    const InLobes lobes = in_lobes(at, shadow.direction, rays);
    const auto weighed = [density](const Scattered& lobe, float chance) {
        return lobe.value * power_heuristic(density, chance * lobe.density);
    };
    const Rgb sent =
        weighed(lobes.gathered, rays.gathered) + weighed(lobes.followed, rays.followed);
    const Rgb out = sent / density * light_radiance(scene, light, -shadow.direction);
    if (is_black(out) || scene.rays.occluded(shadow))
        return Rgb(0);
    return out;
}

Rgb found_light(const RenderScene& scene, const Interaction& at, RandomSequence& random)
{
    if (scene.lights.emissive_faces.empty() && is_black(scene.lights.environment))
        return Rgb(0);
    const ScatterSample sample = sample_scatter(at, Lobes::gathered, random);
    if (is_black(sample.weight))
        return Rgb(0);
    const Ray ray = scattered_ray(at, sample);
    const std::optional<RayHit> hit = scene.rays.nearest(ray);
    if (!hit)
        return sample.weight * scene.lights.environment;
    const Bsdf& bsdf = scene.bsdfs[scene.mesh().material_of_face[hit->face]];
    if (is_black(bsdf.emission))
        return Rgb(0);
    const SurfacePoint light = surface_point(scene.mesh(), hit->face, hit->barycentric);
    if (!shines_towards(bsdf, light, -ray.direction))
        return Rgb(0);
    return sample.weight * emission_at(scene, hit->face, hit->barycentric) *
           hit_weight(scene, light, ray.direction, hit->distance, source_at(at, sample.density));
}

Rgb sampled_light(const RenderScene& scene, const Interaction& at, const LobeRays& rays,
                  RandomSequence& random)
{
    return punctual_light(scene, at, rays, random) + emissive_light(scene, at, rays, random);
}

} // namespace hipmap
