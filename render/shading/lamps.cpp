#include "render/shading/lamps.h"

#include "common/math/frame.h"
#include "common/math/sampling.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hipmap {

namespace {

bool is_area(const LightSet& lights, std::size_t lamp)
{
    return lamp >= lights.punctual.size();
}

const AreaLight& area_light(const LightSet& lights, std::size_t lamp)
{
    return lights.area[lamp - lights.punctual.size()];
}

/// 1 - cos of the half angle of a sun.
float sun_height(const PunctualLight& light)
{
    const float sine = std::sin(0.5f * light.half_angle);
    return 2 * sine * sine;
}

Rgb sun_radiance(const PunctualLight& light)
{
    const float sine = std::sin(light.half_angle);
    return light.intensity / (kPi * sine * sine);
}

/// 1 - cos of the half angle that a sphere fills; 0: none that can be told, or seen from inside.
float ball_height(const PunctualLight& light, float distance2)
{
    const float radius2 = light.radius * light.radius;
    if (!(distance2 > radius2))
        return 0;
    const float sin2 = radius2 / distance2;
    return sin2 / (1 + std::sqrt(1 - sin2));
}

/// Chance per solid angle of a direction drawn evenly from a cone.
float cone_density(float height)
{
    return 1 / (2 * kPi * height);
}

/// Along `direction`, away from it.
Rgb ball_radiance(const PunctualLight& light, const glm::vec3& direction)
{
    return light_intensity(light, direction) / (kPi * light.radius * light.radius);
}

LampSample sample_sun(const PunctualLight& light, const glm::vec2& u)
{
    LampSample out;
    out.is_far = true;
    out.direction = -light.direction;
    out.light = light.intensity;
    if (light.half_angle > 0) {
        out.direction = -leave_sun(light, u);
        out.density = cone_density(sun_height(light));
        out.light = sun_radiance(light) / out.density;
    }
    return out;
}

std::optional<LampSample> sample_ball(const PunctualLight& light, const glm::vec3& position,
                                      const glm::vec2& u)
{
    const glm::vec3 way = light.position - position;
    const float distance2 = glm::dot(way, way), distance = std::sqrt(distance2);
    if (!(distance2 > light.radius * light.radius))
        return std::nullopt;
    LampSample out;
    const float height = ball_height(light, distance2);
    if (!(height > 0)) {
        out.direction = way / distance;
        out.point = light.position;
        out.light = light_intensity(light, -out.direction) / distance2;
        return out;
    }
    const float below = height * u.x;
    out.direction = Frame(way / distance).to_world(direction_below_pole(below, u.y));
    const float across2 = distance2 * below * (2 - below);
    const float inside = std::sqrt(std::max(0.0f, light.radius * light.radius - across2));
    out.point = position + out.direction * (distance * (1 - below) - inside);
    out.density = cone_density(height);
    out.light = ball_radiance(light, -out.direction) / out.density;
    return out;
}

std::optional<LampSample> sample_area(const AreaLight& light, const glm::vec3& position,
                                      const glm::vec2& u)
{
    LampSample out;
    out.point = point_on(light, u);
    const glm::vec3 way = out.point - position;
    const float distance2 = glm::dot(way, way);
    out.direction = way / std::sqrt(distance2);
    const float cosine = -glm::dot(out.direction, light.direction);
    if (!(cosine > 0))
        return std::nullopt; // from behind, or from within its plane
    out.density = static_cast<float>(distance2 / (cosine * lamp_area(light)));
    out.light = light.radiance / out.density;
    return out;
}

std::optional<LampHit> meet_sun(const PunctualLight& light, const Ray& ray)
{
    const float height = sun_height(light);
    const glm::vec3 sine = glm::cross(light.direction, ray.direction); // steadier than the cosine
    const bool wide = light.half_angle > 0.1f;
    const float cosine = -glm::dot(light.direction, ray.direction);
    if (!(cosine > 0) ||
        !(wide ? 1 - cosine < height : glm::dot(sine, sine) < height * (2 - height)))
        return std::nullopt;
    return LampHit{std::numeric_limits<float>::infinity(), sun_radiance(light),
                   cone_density(height)};
}

std::optional<LampHit> meet_ball(const PunctualLight& light, const Ray& ray)
{
    const glm::vec3 way = light.position - ray.origin;
    const float distance2 = glm::dot(way, way), along = glm::dot(way, ray.direction);
    const float height = ball_height(light, distance2);
    if (!(height > 0) || !(along > 0))
        return std::nullopt;
    const glm::vec3 across = way - along * ray.direction;
    const float inside2 = light.radius * light.radius - glm::dot(across, across);
    if (!(inside2 > 0))
        return std::nullopt;
    return LampHit{along - std::sqrt(inside2), ball_radiance(light, -ray.direction),
                   cone_density(height)};
}

std::optional<LampHit> meet_area(const AreaLight& light, const Ray& ray)
{
    const float cosine = -glm::dot(ray.direction, light.direction);
    if (!(cosine > 0))
        return std::nullopt;
    const float distance = -glm::dot(light.centre - ray.origin, light.direction) / cosine;
    if (!(distance > 0))
        return std::nullopt;
    // The point in units of the sides, which need not be at right angles.
    const glm::dvec3 from(ray.origin + distance * ray.direction - light.centre);
    const glm::dvec3 right(light.half_right), up(light.half_up);
    const double rr = glm::dot(right, right), uu = glm::dot(up, up), ru = glm::dot(right, up);
    const double fr = glm::dot(from, right), fu = glm::dot(from, up), whole = rr * uu - ru * ru;
    const double x = (fr * uu - fu * ru) / whole, y = (fu * rr - fr * ru) / whole;
    if (!(light.is_disc ? x * x + y * y < 1 : std::abs(x) < 1 && std::abs(y) < 1))
        return std::nullopt;
    return LampHit{distance, light.radiance,
                   static_cast<float>(double{distance} * distance / (cosine * lamp_area(light)))};
}

} // namespace

std::size_t lamp_count(const LightSet& lights)
{
    return lights.punctual.size() + lights.area.size();
}

bool has_size(const LightSet& lights, std::size_t lamp)
{
    if (is_area(lights, lamp))
        return true;
    const PunctualLight& light = lights.punctual[lamp];
    return light.kind == LightKind::directional ? light.half_angle > 0 : light.radius > 0;
}

Rgb lamp_power(const LightSet& lights, std::size_t lamp)
{
    if (!is_area(lights, lamp))
        return light_power(lights.punctual[lamp], lights.radius);
    const AreaLight& light = area_light(lights, lamp);
    return light.radiance * static_cast<float>(kPi * lamp_area(light));
}

LightBounds bounds_of_lamp(const LightSet& lights, std::size_t lamp)
{
    LightBounds out;
    if (is_area(lights, lamp)) {
        const AreaLight& light = area_light(lights, lamp);
        for (const float right : {-1.0f, 1.0f})
            for (const float up : {-1.0f, 1.0f})
                out.box.add(light.centre + right * light.half_right + up * light.half_up);
        out.axis = light.direction;
        out.power = max_channel(light.radiance) * lamp_area(light);
        return out;
    }
    const PunctualLight& light = lights.punctual[lamp];
    out.power = max_channel(light.intensity);
    out.box.add(light.position - light.radius);
    out.box.add(light.position + light.radius);
    out.axis = light.direction;
    if (light.kind == LightKind::spot)
        out.cos_reach = light.cos_outer;
    else
        out.cos_spread = -1;
    return out;
}

std::optional<LampSample> sample_lamp(const LightSet& lights, std::size_t lamp,
                                      const glm::vec3& position, const glm::vec2& u)
{
    if (is_area(lights, lamp))
        return sample_area(area_light(lights, lamp), position, u);
    const PunctualLight& light = lights.punctual[lamp];
    if (light.kind == LightKind::directional)
        return sample_sun(light, u);
    return sample_ball(light, position, u);
}

std::optional<LampHit> meet_lamp(const LightSet& lights, std::size_t lamp, const Ray& ray)
{
    if (!has_size(lights, lamp))
        return std::nullopt;
    if (is_area(lights, lamp))
        return meet_area(area_light(lights, lamp), ray);
    const PunctualLight& light = lights.punctual[lamp];
    return light.kind == LightKind::directional ? meet_sun(light, ray) : meet_ball(light, ray);
}

glm::vec3 leave_ball(const PunctualLight& light, const glm::vec3& direction, const glm::vec2& u)
{
    const glm::vec2 disc = sample_disc(u);
    const Frame frame(direction);
    const float height = std::sqrt(std::max(0.0f, 1 - glm::dot(disc, disc)));
    return light.position +
           light.radius * (frame.x * disc.x + frame.y * disc.y + direction * height);
}

glm::vec3 leave_sun(const PunctualLight& light, const glm::vec2& u)
{
    return Frame(light.direction).to_world(direction_below_pole(sun_height(light) * u.x, u.y));
}

glm::vec3 point_on(const AreaLight& light, const glm::vec2& u)
{
    const glm::vec2 at = light.is_disc ? sample_disc(u) : 2.0f * u - 1.0f;
    return light.centre + at.x * light.half_right + at.y * light.half_up;
}

double lamp_area(const AreaLight& light)
{
    const double rectangle =
        4 * glm::length(glm::cross(glm::dvec3(light.half_right), glm::dvec3(light.half_up)));
    return light.is_disc ? rectangle * (kPi / 4) : rectangle;
}

glm::vec3 direction_below_pole(float below, float u)
{
    const float sine = std::sqrt(below * (2 - below)), phi = 2 * kPi * u;
    return {sine * std::cos(phi), sine * std::sin(phi), 1 - below};
}

} // namespace hipmap
