#include "render/paths/direct_light.h"

#include "common/rays/flat_point.h"
#include "render/shading/scatter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hipmap {

namespace {

/// Shadow rays towards those lights that a tree chooses from.
constexpr int kChosenLights = 4;

/// A light sample in both sets of lobes.
struct InLobes {
    Scattered gathered, followed;
};

/// The weight of light found with pdf `own`, against another way that finds it with `other`: the
/// power heuristic.  The balance heuristic would let the odd ray of a diffuse lobe that runs into a
/// small light count for as much as all samples of the light.  own > 0.
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
    if (rays.guide != nullptr)
        out.gathered.pdf = mixed_pdf(*rays.guide, out.gathered.pdf, direction);
    if (rays.followed > 0)
        out.followed = scattered(at, direction, Lobes::followed);
    return out;
}

/// What the lobes send of the light found with `pdf` in a direction.
Rgb weighed(const InLobes& lobes, const LobeRays& rays, float pdf)
{
    const Rgb gathered =
        lobes.gathered.value * power_heuristic(pdf, rays.gathered * lobes.gathered.pdf);
    if (!(rays.followed > 0))
        return gathered;
    return gathered +
           lobes.followed.value * power_heuristic(pdf, rays.followed * lobes.followed.pdf);
}

/// Rough glass, and what passes light diffusely, takes light from both sides.
LightReceiver receiver(const Interaction& at)
{
    const bool both = at.bsdf().transmits || at.bsdf().transmits_diffusely;
    return {at.point.position, both ? glm::vec3(0) : at.normal};
}

/// A light to sample.
struct SampledLight {
    const Light& light;
    double samples = 1; ///< of the light at a point, on average
};

/// The density of the samples by a guide to the sky.
float sky_pdf(const DirectionGuide* sky, const glm::vec3& direction)
{
    return sky == nullptr ? 0 : mixed_pdf(*sky, 0, direction);
}

Rgb from_light(const RenderScene& scene, const Interaction& at, const SampledLight& sampled,
               const LobeRays& rays, RandomSequence& random)
{
    const std::optional<LightSample> sample = sample_li(sampled.light, receiver(at), random);
    if (!sample)
        return Rgb(0);
    const Ray shadow = shadow_ray(at.point, *sample);
    const InLobes lobes = in_lobes(at, shadow.direction, rays);
    const Rgb value = sample->pdf > 0
                          ? weighed(lobes, rays, static_cast<float>(sampled.samples * sample->pdf))
                          : lobes.gathered.value + lobes.followed.value;
    const Rgb sent = value * sample->light / static_cast<float>(sampled.samples);
    return is_black(sent) ? sent : sent * unoccluded(scene, at, shadow);
}

/// The light of a hit, weighed against sampling it `chosen()` times.
template <typename Chosen>
Rgb weighed_hit(const LightHit& hit, const RaySource& source, const Chosen& chosen)
{
    return hit.radiance * (source.pdf > 0 ? power_heuristic(source.pdf, chosen() * hit.pdf)
                                          : weight_against_photons(hit.radiance, source));
}

/// The analytic lights along a ray; `left(distance)` is what is left of light from there.
template <typename Left>
Rgb add_lights(const RenderScene& scene, const Ray& ray, float distance, const RaySource& source,
               const Left& left)
{
    const LightSet& lights = scene.lights;
    Rgb sum(0.0f);
    if (source.eye || !has_met_lights(lights))
        return sum;
    const auto add = [&](std::uint32_t light, const auto& chosen) {
        std::optional<LightHit> hit = intersect(lights.lights[light], ray);
        if (!hit || !(hit->distance <= distance))
            return;
        hit->radiance *= left(hit->distance);
        sum += weighed_hit(*hit, source, chosen);
    };
    for (const std::uint32_t light : lights.met)
        add(light, [] { return 1.0f; });
    if (lights.chosen_are_met)
        over_lights_along(lights.tree, ray.origin, ray.direction, [&](std::uint32_t place) {
            add(lights.chosen[place], [&] {
                return static_cast<float>(kChosenLights *
                                          probability_of(lights.tree, source.at, place));
            });
        });
    return sum;
}

/// Radiance towards `at.back` of light straight from analytic lights: all of them, or some chosen
/// by a tree.
Rgb analytic_light(const RenderScene& scene, const Interaction& at, const LobeRays& rays,
                   RandomSequence& random)
{
    const LightSet& lights = scene.lights;
    Rgb sum(0.0f);
    for (const std::uint32_t light : lights.sampled)
        sum += from_light(scene, at, {.light = lights.lights[light]}, rays, random);
    if (lights.tree.empty())
        return sum;
    const LightReceiver from = receiver(at);
    for (int i = 0; i < kChosenLights; ++i) {
        const double u = (i + double{random.next()}) / kChosenLights;
        if (const std::optional<ChosenLight> chosen = choose_light(lights.tree, from, u))
            sum += from_light(scene, at,
                              {.light = lights.lights[lights.chosen[chosen->light]],
                               .samples = kChosenLights * chosen->probability},
                              rays, random);
    }
    return sum;
}

/// The light of an environment from a direction that its own samples or the guide have drawn
/// (balance heuristic).
Rgb from_sky(const RenderScene& scene, const Interaction& at, const Light& environment,
             const glm::vec3& direction, const LobeRays& rays)
{
    const Ray shadow = ray_from(at.point, direction);
    const std::optional<LightHit> hit = intersect(environment, shadow);
    if (!hit)
        return Rgb(0);
    const float pdf = hit->pdf + sky_pdf(rays.sky, direction);
    const Rgb sent = pdf > 0
                         ? weighed(in_lobes(at, direction, rays), rays, pdf) * (hit->radiance / pdf)
                         : Rgb(0);
    return is_black(sent) ? sent : sent * unoccluded(scene, at, shadow);
}

/// Radiance towards `at.back` of light straight from the environments, by samples of their own and
/// one by a guide to the sky.
Rgb environment_light(const RenderScene& scene, const Interaction& at, const LobeRays& rays,
                      RandomSequence& random)
{
    Rgb sum(0.0f);
    const std::optional<glm::vec3> guided =
        rays.sky != nullptr ? std::optional(draw(*rays.sky, random.next2())) : std::nullopt;
    for (const std::uint32_t place : scene.lights.environments) {
        const Light& light = scene.lights.lights[place];
        if (!guided) {
            sum += from_light(scene, at, {.light = light}, rays, random);
            continue;
        }
        sum += from_sky(scene, at, light, *guided, rays);
        if (const std::optional<LightSample> own = sample_li(light, receiver(at), random))
            sum += from_sky(scene, at, light, own->direction, rays);
    }
    return sum;
}

/// The light of one of the points that are drawn on the emissive faces, of which there must be
/// some.
Rgb from_faces(const RenderScene& scene, const Interaction& at, const LobeRays& rays,
               RandomSequence& random, const PointPlace& of)
{
    const EmissiveMesh& faces = scene.lights.faces;
    const std::optional<EmissivePoint> light = sample_point(faces, receiver(at), random, of);
    if (!light)
        return Rgb(0);
    const Ray shadow = ray_between(at.point, light->surface);
    const float distance = glm::length(light->surface.position - at.point.position);
    const float pdf = static_cast<float>(of.points) *
                      per_solid_angle(light->area_pdf, light->surface, shadow.direction, distance);
    if (!(pdf > 0))
        return Rgb(0);
    const Rgb sent = weighed(in_lobes(at, shadow.direction, rays), rays, pdf);
    const Rgb out = sent / pdf * radiance_towards(faces, *light, -shadow.direction);
    return is_black(out) ? out : out * unoccluded(scene, at, shadow);
}

} // namespace

float distance_of(const std::optional<RayHit>& hit)
{
    return hit ? hit->distance : std::numeric_limits<float>::infinity();
}

RaySource source_at(const Interaction& at, float pdf)
{
    return {receiver(at), pdf};
}

float hit_weight(const RenderScene& scene, const SurfacePoint& on_light, const glm::vec3& direction,
                 float distance, const RaySource& source)
{
    if (source.pdf == 0 || scene.lights.faces.empty())
        return 1;
    const float pdf = pdf_li(scene.lights.faces, source.at, on_light, direction, distance);
    return power_heuristic(source.pdf, static_cast<float>(source.points) * pdf);
}

Rgb lights_on_way(const RenderScene& scene, const Ray& ray, float distance, const Rgb& absorption,
                  const RaySource& source)
{
    return add_lights(scene, ray, distance, source,
                      [&](float to_light) { return transmittance(absorption, to_light); });
}

Rgb met_lights_in_media(const RenderScene& scene, const Ray& ray, const MediumStack& inside,
                        const RaySource& source)
{
    return add_lights(scene, ray, std::numeric_limits<float>::infinity(), source,
                      [&](float to_light) {
                          Ray way = ray;
                          way.far = to_light;
                          return let_through(*scene.media, way, inside);
                      });
}

Rgb met_environment(const RenderScene& scene, const glm::vec3& direction, const RaySource& source)
{
    Ray ray;
    ray.direction = direction;
    Rgb sum(0.0f);
    for (const std::uint32_t light : scene.lights.environments)
        if (std::optional<LightHit> hit = intersect(scene.lights.lights[light], ray)) {
            hit->pdf += sky_pdf(source.sky, direction);
            sum += weighed_hit(*hit, source, [] { return 1.0f; });
        }
    return sum;
}

Rgb emissive_light(const RenderScene& scene, const Interaction& at, const LobeRays& rays,
                   RandomSequence& random)
{
    Rgb sum(0.0f);
    if (!scene.lights.faces.empty())
        for (int i = 0; i < rays.points; ++i)
            sum += from_faces(scene, at, rays, random, {i, rays.points});
    return sum;
}

Rgb bsdf_sampled_light(const RenderScene& scene, const Interaction& at, const LobeRays& rays,
                       RandomSequence& random)
{
    if (!can_be_met(scene.lights))
        return Rgb(0);
    const ScatterSample sample = sample_scatter(at, Lobes::gathered, random);
    if (is_black(sample.weight))
        return Rgb(0);
    const Ray ray = scattered_ray(at, sample);
    RaySource source = source_at(at, sample.pdf);
    source.sky = rays.sky;
    source.points = rays.points;
    Rgb throughput = sample.weight;
    const std::optional<RayHit> hit = first_surface(scene, at, ray, throughput);
    const MediumStack inside = medium_stack_towards(scene, at, ray.direction);
    const Rgb on_way =
        sample.weight * (!at.in_media() ? met_lights(scene, ray, distance_of(hit), Rgb(0), source)
                                        : met_lights_in_media(scene, ray, inside, source));
    if (!hit)
        return on_way + throughput * met_environment(scene, ray.direction, source);
    const Bsdf& bsdf = scene.bsdfs[scene.mesh().material_of(hit->face)];
    if (is_black(bsdf.emission))
        return on_way;
    const SurfacePoint light = flat_point(scene.mesh(), hit->face, hit->barycentric);
    if (!emits_towards(bsdf, light, -ray.direction))
        return on_way;
    return on_way + throughput * emission_at(scene, hit->face, hit->barycentric) *
                        hit_weight(scene, light, ray.direction, hit->distance, source);
}

Rgb light_of_all_kinds(const RenderScene& scene, const Interaction& at, const LobeRays& rays,
                       RandomSequence& random)
{
    Rgb sum = emissive_light(scene, at, rays, random);
    sum += analytic_light(scene, at, rays, random);
    return sum + environment_light(scene, at, rays, random);
}

} // namespace hipmap
