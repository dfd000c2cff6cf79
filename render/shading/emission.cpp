#include "render/shading/emission.h"

#include "common/math/frame.h"
#include "common/math/sampling.h"
#include "render/shading/lamps.h"

#include <algorithm>
#include <cmath>

namespace hipmap {

namespace {

/// The share of all paths that is dealt out evenly, so that no light is left without.
constexpr double kFloorShare = 0.1;

/// Along parallel light: a point of the disc across `direction` that covers the scene's sphere,
/// moved back to where the sphere begins.
Ray ray_into_scene(const LightSet& lights, const glm::vec3& direction, const glm::vec2& u)
{
    const Frame frame(direction);
    const glm::vec2 d = sample_disc(u) * lights.radius;
    Ray ray;
    ray.origin = lights.centre + frame.x * d.x + frame.y * d.y - direction * (2 * lights.radius);
    ray.direction = direction;
    return ray;
}

EmittedPath emit_from_spot(const PunctualLight& light, RandomSequence& random)
{
    // Inner cone and rim are picked by their power; within the rim the density follows the
    // fall-off.
    const float inner = 1 - light.cos_inner;
    const float rim = (light.cos_inner - light.cos_outer) / 3;
    const float u = random.next() * (inner + rim);
    float cosine;
    if (u < inner) {
        cosine = 1 - u;
    } else {
        const float t = std::cbrt((u - inner) / rim);
        cosine = light.cos_outer + t * (light.cos_inner - light.cos_outer);
    }
    EmittedPath out;
    out.ray.origin = light.position;
    out.ray.direction = Frame(light.direction)
                            .to_world(direction_from_cosine(std::min(cosine, 1.0f), random.next()));
    return out;
}

EmittedPath emit_from_punctual(const LightSet& lights, const PunctualLight& light,
                               RandomSequence& random)
{
    EmittedPath out;
    if (light.kind == LightKind::spot) {
        out = emit_from_spot(light, random);
    } else if (light.kind == LightKind::point) {
        out.ray.origin = light.position;
        out.ray.direction = sample_sphere(random.next2());
    } else {
        const glm::vec3 direction =
            light.half_angle > 0 ? leave_sun(light, random.next2()) : light.direction;
        out.ray = ray_into_scene(lights, direction, random.next2());
    }
    if (light.kind != LightKind::directional && light.radius > 0)
        out.ray.origin = leave_ball(light, out.ray.direction, random.next2());
    out.power = light_power(light, lights.radius);
    return out;
}

EmittedPath emit_from_area(const AreaLight& light, RandomSequence& random)
{
    EmittedPath out;
    out.ray.origin = point_on(light, random.next2());
    out.ray.direction = Frame(light.direction).to_world(sample_cosine_hemisphere(random.next2()));
    out.power = light.radiance * static_cast<float>(kPi * lamp_area(light));
    return out;
}

EmittedPath emit_from_face(const RenderScene& scene, double u_face, RandomSequence& random)
{
    const TriangleMesh& mesh = scene.mesh();
    const EmissivePoint from = sample_emissive_point(scene.lights, mesh, u_face, random.next2());
    const Bsdf& bsdf = scene.bsdfs[mesh.material_of_face[from.surface.face]];
    const bool behind = bsdf.emits_behind && random.next() < 0.5f;
    const glm::vec3 normal =
        behind ? -from.surface.geometric_normal : from.surface.geometric_normal;
    EmittedPath out;
    out.ray.direction = Frame(normal).to_world(sample_cosine_hemisphere(random.next2()));
    out.ray.origin = offset_origin(from.surface, normal);
    out.power = light_radiance(scene, from, normal) *
                (kPi * (bsdf.emits_behind ? 2.0f : 1.0f) / from.density);
    return out;
}

EmittedPath emit_from_sky(const LightSet& lights, RandomSequence& random)
{
    EmittedPath out;
    const SkyLight sky = sample_sky_light(lights, random.next2());
    out.ray = ray_into_scene(lights, sky.direction, random.next2());
    out.power = sky.light * (kPi * lights.radius * lights.radius);
    return out;
}

std::vector<double> powers_of(const LightSet& lights, double glow)
{
    std::vector<double> out;
    for (std::size_t lamp = 0; lamp < lamp_count(lights); ++lamp)
        out.push_back(max_channel(lamp_power(lights, lamp)));
    out.push_back(lights.emissive_power);
    const double flux =
        lights.sky.empty() ? 4.0 * kPi * max_channel(lights.environment) : lights.sky.flux;
    out.push_back(kPi * lights.radius * lights.radius * flux);
    out.push_back(glow);
    return out;
}

} // namespace

SkyLight sample_sky_light(const LightSet& lights, const glm::vec2& u)
{
    if (lights.sky.empty())
        return {sample_sphere(u), lights.environment * (4 * kPi)};
    const glm::vec3 back = sample_sky(lights.sky, u);
    const float density = sky_density(lights.sky, back);
    return {-back, density > 0 ? sky_radiance(lights.sky, back) / density : Rgb(0)};
}

EmissionPlan plan_emission(const LightSet& lights, std::uint64_t paths, double glow)
{
    const std::vector<double> powers = powers_of(lights, glow);
    double total = 0;
    std::size_t shining = 0;
    for (double power : powers) {
        total += power;
        shining += power > 0 ? 1 : 0;
    }
    EmissionPlan plan;
    plan.first_path.push_back(0);
    for (double power : powers) {
        if (power > 0 && paths > 0) {
            const double share =
                kFloorShare / static_cast<double>(shining) + (1 - kFloorShare) * power / total;
            plan.paths += std::max<std::uint64_t>(
                1, static_cast<std::uint64_t>(std::llround(share * static_cast<double>(paths))));
        }
        plan.first_path.push_back(plan.paths);
    }
    return plan;
}

LightShare share_of(const EmissionPlan& plan, std::uint64_t path)
{
    const auto after = std::upper_bound(plan.first_path.begin(), plan.first_path.end(), path);
    const std::size_t light = static_cast<std::size_t>(after - plan.first_path.begin()) - 1;
    const std::uint64_t first = plan.first_path[light];
    return {light, path - first, plan.first_path[light + 1] - first};
}

double stratum(const LightShare& share, RandomSequence& random)
{
    return (static_cast<double>(share.place) + random.next()) / static_cast<double>(share.paths);
}

EmittedPath emit_path(const RenderScene& scene, const EmissionPlan& plan, std::uint64_t path,
                      RandomSequence& random)
{
    const LightSet& lights = scene.lights;
    const LightShare share = share_of(plan, path);
    EmittedPath out;
    if (share.light < lights.punctual.size()) {
        out = emit_from_punctual(lights, lights.punctual[share.light], random);
    } else if (share.light < lamp_count(lights)) {
        out = emit_from_area(lights.area[share.light - lights.punctual.size()], random);
    } else if (share.light == lamp_count(lights)) {
        // Stratified over the faces: the paths walk through the running sum of powers.
        out = emit_from_face(scene, stratum(share, random), random);
    } else if (share.light > lamp_count(lights) + 1) {
        const GlowPath glow = sample_glow(*scene.media, random);
        out = {glow.ray, glow.power, true};
    } else {
        out = emit_from_sky(lights, random);
    }
    out.power /= static_cast<float>(share.paths);
    return out;
}

} // namespace hipmap
