#include "render/photons/aimed_emission.h"

#include "common/math/sampling.h"

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
    const AimedRay aimed = aim_from_point(targets, light.position, cone, random);
    EmittedPath out;
    out.ray.origin = light.position;
    out.ray.direction = aimed.direction;
    out.power = light_intensity(light, aimed.direction) * aimed.weight;
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
        out = light.kind == LightKind::directional
                  ? aim_along(lights, light.direction, light.intensity, targets, random)
                  : aim_from_light(light, targets, random);
    } else if (share.light == lights.punctual.size()) {
        out = aim_from_face(scene, stratum(share, random), targets, random);
    } else {
        const glm::vec3 direction = sample_sphere(random.next2());
        out = aim_along(lights, direction, lights.environment * (4 * kPi), targets, random);
    }
    out.power /= static_cast<float>(share.paths);
    return out;
}

} // namespace hipmap
