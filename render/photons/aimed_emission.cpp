#include "render/photons/aimed_emission.h"

#include "common/math/sampling.h"
#include "render/shading/lamps.h"

#include <algorithm>
#include <cmath>

namespace hipmap {

namespace {

using Targets = std::vector<TargetSphere>;

EmittedPath aim_from_light(const PunctualLight& light, const Targets& targets,
                           RandomSequence& random)
{
    LightCone cone;
    if (light.kind == LightKind::spot)
        cone = {light.direction, std::acos(light.cos_outer)};
    EmittedPath out;
    out.ray.origin = light.position;
    glm::vec3 normal(0.0f);
    if (light.radius > 0) {
        normal = sample_sphere(random.next2());
        out.ray.origin += light.radius * normal;
    }
    const AimedRay aimed = aim_from_point(targets, out.ray.origin, cone, random);
    out.ray.direction = aimed.direction;
    out.power = light_intensity(light, aimed.direction) * aimed.weight;
    if (light.radius > 0) // radiance times cosine times area
        out.power *= 4 * std::max(0.0f, glm::dot(normal, aimed.direction));
    return out;
}

EmittedPath aim_from_area(const AreaLight& light, const Targets& targets, RandomSequence& random)
{
    EmittedPath out;
    out.ray.origin = point_on(light, random.next2());
    const AimedRay aimed =
        aim_from_point(targets, out.ray.origin, {light.direction, kPi / 2}, random);
    out.ray.direction = aimed.direction;
    const float cosine = std::max(0.0f, glm::dot(light.direction, aimed.direction));
    out.power = light.radiance * (static_cast<float>(lamp_area(light)) * cosine * aimed.weight);
    return out;
}

/// light: W/m2 across the direction, times 1 over the density of the direction.
EmittedPath aim_along(const LightSet& lights, const glm::vec3& direction, const Rgb& light,
                      const Targets& targets, RandomSequence& random)
{
    const AimedPoint aimed = aim_parallel(targets, direction, random);
    const float behind = glm::dot(aimed.position - lights.centre, direction) + 2 * lights.radius;
    EmittedPath out;
    out.ray.origin = aimed.position - direction * behind;
    out.ray.direction = direction;
    out.power = light * aimed.weight;
    return out;
}

EmittedPath aim_from_sun(const LightSet& lights, const PunctualLight& light, const Targets& targets,
                         RandomSequence& random)
{
    const glm::vec3 direction =
        light.half_angle > 0 ? leave_sun(light, random.next2()) : light.direction;
    const float across = kPi * lights.radius * lights.radius;
    return aim_along(lights, direction, light_power(light, lights.radius) / across, targets,
                     random);
}

EmittedPath aim_from_face(const RenderScene& scene, double u_face, const Targets& targets,
                          RandomSequence& random)
{
    const EmissivePoint from =
        sample_emissive_point(scene.lights, scene.mesh(), u_face, random.next2());
    const Bsdf& bsdf = scene.bsdfs[scene.mesh().material_of_face[from.surface.face]];
    LightCone cone;
    if (!bsdf.emits_behind)
        cone = {from.surface.geometric_normal, kPi / 2};
    const AimedRay aimed = aim_from_point(targets, from.surface.position, cone, random);
    const float cosine = std::abs(glm::dot(aimed.direction, from.surface.geometric_normal));
    EmittedPath out;
    out.ray.direction = aimed.direction;
    out.ray.origin = offset_origin(from.surface, aimed.direction);
    out.power =
        light_radiance(scene, from, aimed.direction) * (cosine * aimed.weight / from.density);
    return out;
}

} // namespace

EmittedPath emit_aimed_path(const RenderScene& scene, const EmissionPlan& plan,
                            const std::vector<TargetSphere>& targets, std::uint64_t path,
                            RandomSequence& random)
{
    const LightSet& lights = scene.lights;
    const LightShare share = share_of(plan, path);
    EmittedPath out;
    if (share.light < lights.punctual.size()) {
        const PunctualLight& light = lights.punctual[share.light];
        out = light.kind == LightKind::directional ? aim_from_sun(lights, light, targets, random)
                                                   : aim_from_light(light, targets, random);
    } else if (share.light < lamp_count(lights)) {
        out = aim_from_area(lights.area[share.light - lights.punctual.size()], targets, random);
    } else if (share.light == lamp_count(lights)) {
        out = aim_from_face(scene, stratum(share, random), targets, random);
    } else {
        const SkyLight sky = sample_sky_light(lights, random.next2());
        out = aim_along(lights, sky.direction, sky.light, targets, random);
    }
    out.power /= static_cast<float>(share.paths);
    return out;
}

} // namespace hipmap
