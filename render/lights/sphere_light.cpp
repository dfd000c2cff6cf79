#include "render/lights/sphere_light.h"

#include "common/math/frame.h"
#include "render/lights/cone.h"

#include <algorithm>
#include <cmath>

namespace hipmap {

namespace {

/// Height of the cone that the sphere fills; 0: too thin for float, or seen from inside.
float cone_height(const SphereLight& light, float distance2)
{
    const float radius2 = light.radius * light.radius;
    if (!(distance2 > radius2))
        return 0;
    const float sin2 = radius2 / distance2;
    return sin2 / (1 + std::sqrt(1 - sin2));
}

/// direction: unit, away from the light.
Rgb intensity_along(const SphereLight& light, const glm::vec3& direction)
{
    return light.cone ? light.intensity * falloff(*light.cone, direction) : light.intensity;
}

Rgb radiance_along(const SphereLight& light, const glm::vec3& direction)
{
    return intensity_along(light, direction) / (kPi * light.radius * light.radius);
}

/// Evenly over what is seen of the sphere from along `direction`.
glm::vec3 point_facing(const SphereLight& light, const glm::vec3& direction, const glm::vec2& u)
{
    const glm::vec2 disc = sample_disc(u);
    const Frame frame(direction);
    const float height = std::sqrt(std::max(0.0f, 1 - glm::dot(disc, disc)));
    return light.position +
           light.radius * (frame.x * disc.x + frame.y * disc.y + direction * height);
}

} // namespace

std::optional<LightSample> sample_li(const SphereLight& light, const LightReceiver& at,
                                     RandomSequence& random)
{
    const glm::vec2 u = random.next2();
    const glm::vec3 way = light.position - at.position;
    const float distance2 = glm::dot(way, way), distance = std::sqrt(distance2);
    if (!(distance2 > light.radius * light.radius))
        return std::nullopt;
    LightSample out;
    const float height = cone_height(light, distance2);
    if (!(height > 0)) {
        out.direction = way / distance;
        out.point = light.position;
        out.light = intensity_along(light, -out.direction) / distance2;
        return out;
    }
    const float below = height * u.x;
    out.direction = Frame(way / distance).to_world(direction_below_pole(below, u.y));
    const float across2 = distance2 * below * (2 - below);
    const float inside = std::sqrt(std::max(0.0f, light.radius * light.radius - across2));
    out.point = at.position + out.direction * (distance * (1 - below) - inside);
    out.pdf = cone_pdf(height);
    out.light = radiance_along(light, -out.direction) / out.pdf;
    return out;
}

std::optional<LightHit> intersect(const SphereLight& light, const Ray& ray)
{
    const glm::vec3 way = light.position - ray.origin;
    const float distance2 = glm::dot(way, way), along = glm::dot(way, ray.direction);
    const float height = cone_height(light, distance2);
    if (!(height > 0) || !(along > 0))
        return std::nullopt;
    const glm::vec3 across = way - along * ray.direction;
    const float inside2 = light.radius * light.radius - glm::dot(across, across);
    if (!(inside2 > 0))
        return std::nullopt;
    return LightHit{along - std::sqrt(inside2), radiance_along(light, -ray.direction),
                    cone_pdf(height)};
}

EmittedPath sample_emission(const SphereLight& light, const PathPlace&, RandomSequence& random)
{
    EmittedPath out;
    out.ray.direction =
        light.cone ? sample_direction(*light.cone, random) : sample_sphere(random.next2());
    out.ray.origin = point_facing(light, out.ray.direction, random.next2());
    out.power = Rgb(power(light));
    out.radiance = radiance_along(light, out.ray.direction);
    return out;
}

EmittedPath sample_aimed_emission(const SphereLight& light, const PathPlace&,
                                  const std::vector<TargetSphere>& targets, RandomSequence& random)
{
    LightCone cone;
    if (light.cone)
        cone = {light.cone->direction, std::acos(light.cone->cos_outer)};
    const glm::vec3 normal = sample_sphere(random.next2());
    EmittedPath out;
    out.ray.origin = light.position + light.radius * normal;
    const AimedRay aimed = aim_from_point(targets, out.ray.origin, cone, random);
    out.ray.direction = aimed.direction;
    out.radiance = radiance_along(light, aimed.direction);
    // Radiance times cosine times area.
    out.power = intensity_along(light, aimed.direction) * aimed.weight *
                (4 * std::max(0.0f, glm::dot(normal, aimed.direction)));
    return out;
}

glm::dvec3 power(const SphereLight& light)
{
    return glm::dvec3(light.intensity * (light.cone ? falloff_integral(*light.cone) : 4 * kPi));
}

std::optional<LightBounds> bounds(const SphereLight& light)
{
    LightBounds out;
    out.box.add(light.position - light.radius);
    out.box.add(light.position + light.radius);
    out.power = max_channel(light.intensity);
    if (light.cone) {
        out.axis = light.cone->direction;
        out.cos_reach = light.cone->cos_outer;
    } else {
        out.cos_spread = -1;
    }
    return out;
}

} // namespace hipmap
