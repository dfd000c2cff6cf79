#include "render/integrator/direct_light.h"

#include "common/math/frame.h"
#include "common/math/sampling.h"

#include <algorithm>
#include <cmath>

namespace hipmap {

namespace {

/// Most shadow rays towards punctual lights; more lights than that are taken in strata.
constexpr std::size_t kMostPunctual = 16;

Rgb from_punctual(const RenderScene& scene, const Interaction& at, const PunctualLight& light)
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
    const Rgb received = receive(at, shadow.direction) * arriving;
    if (is_black(received) || scene.rays.occluded(shadow))
        return Rgb(0);
    return received;
}

/// One ray by the cosine of the lobe: what emissive face or sky it finds.
Rgb from_hemisphere(const RenderScene& scene, const Interaction& at, RandomSequence& random)
{
    Ray ray;
    ray.direction = Frame(at.shading_normal).to_world(sample_cosine_hemisphere(random.next2()));
    ray.origin = offset_origin(at.point, ray.direction);
    const Rgb received = receive(at, ray.direction);
    if (is_black(received))
        return Rgb(0);
    const float own = glm::dot(ray.direction, at.shading_normal) / kPi;
    const std::optional<RayHit> hit = scene.rays.nearest(ray);
    if (!hit)
        return received * scene.lights.environment / own;
    const Bsdf& bsdf = scene.bsdfs[scene.mesh().material_of_face[hit->face]];
    if (is_black(bsdf.emission) || scene.lights.density.empty())
        return Rgb(0);
    const SurfacePoint light = surface_point(scene.mesh(), hit->face, hit->barycentric);
    const Rgb emitted = emitted_radiance(bsdf, light, -ray.direction);
    const float other = emissive_density(scene, light, ray.direction, hit->distance);
    return received * emitted / (own + other);
}

} // namespace

Rgb receive(const Interaction& at, const glm::vec3& direction)
{
    const float cosine = glm::dot(direction, at.shading_normal);
    if (!(cosine > 0) || !(glm::dot(direction, at.normal) > 0))
        return Rgb(0);
    return coat_half(at.bsdf, cosine) *
           (cosine * diffuse_shape(at.bsdf, at.shading_normal, direction, at.back));
}

float emissive_density(const RenderScene& scene, const SurfacePoint& on_light,
                       const glm::vec3& direction, float distance)
{
    const float cosine = std::abs(glm::dot(direction, on_light.geometric_normal));
    return cosine > 0 ? scene.lights.density[on_light.face] * distance * distance / cosine : 0;
}

Rgb punctual_irradiance(const RenderScene& scene, const Interaction& at, RandomSequence& random)
{
    const std::vector<PunctualLight>& lights = scene.lights.punctual;
    Rgb sum(0.0f);
    if (lights.size() <= kMostPunctual) {
        for (const PunctualLight& light : lights)
            sum += from_punctual(scene, at, light);
        return sum;
    }
    const float stride = static_cast<float>(lights.size()) / kMostPunctual;
    for (std::size_t i = 0; i < kMostPunctual; ++i) {
        const auto pick =
            static_cast<std::size_t>((static_cast<float>(i) + random.next()) * stride);
        sum += stride * from_punctual(scene, at, lights[std::min(pick, lights.size() - 1)]);
    }
    return sum;
}

Rgb emissive_irradiance(const RenderScene& scene, const Interaction& at, float ray_chance,
                        RandomSequence& random)
{
    const float u_face = random.next();
    const EmissivePoint light =
        sample_emissive_point(scene.lights, scene.mesh(), u_face, random.next2());
    const Ray shadow = ray_between(at.point, light.surface.position);
    const float distance = glm::length(light.surface.position - at.point.position);
    const Bsdf& bsdf = scene.bsdfs[scene.mesh().material_of_face[light.surface.face]];
    const Rgb received =
        receive(at, shadow.direction) * emitted_radiance(bsdf, light.surface, -shadow.direction);
    const float density = emissive_density(scene, light.surface, shadow.direction, distance);
    if (is_black(received) || !(density > 0) || scene.rays.occluded(shadow))
        return Rgb(0);
    const float other =
        ray_chance * std::max(0.0f, glm::dot(shadow.direction, at.shading_normal)) / kPi;
    return received / (density + other);
}

Rgb direct_irradiance(const RenderScene& scene, const Interaction& at, RandomSequence& random)
{
    Rgb sum = punctual_irradiance(scene, at, random);
    const bool emissive = !scene.lights.emissive_faces.empty();
    if (emissive)
        sum += emissive_irradiance(scene, at, 1.0f, random);
    if (emissive || !is_black(scene.lights.environment))
        sum += from_hemisphere(scene, at, random);
    return sum;
}

} // namespace hipmap
