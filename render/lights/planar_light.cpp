#include "render/lights/planar_light.h"

#include "common/math/frame.h"
#include "common/math/sampling.h"

#include <algorithm>
#include <cmath>

namespace hipmap {

namespace {

glm::vec3 point_on(const PlanarLight& light, const glm::vec2& u)
{
    const glm::vec2 at =
        light.shape == PlanarLight::Shape::ellipse ? sample_disc(u) : 2.0f * u - 1.0f;
    return light.centre + at.x * light.half_right + at.y * light.half_up;
}

/// point: of its plane.
bool holds(const PlanarLight& light, const glm::vec3& point)
{
    // The point in units of the sides, which need not be at right angles.
    const glm::dvec3 from(point - light.centre), right(light.half_right), up(light.half_up);
    const double rr = glm::dot(right, right), uu = glm::dot(up, up), ru = glm::dot(right, up);
    const double fr = glm::dot(from, right), fu = glm::dot(from, up), whole = rr * uu - ru * ru;
    const double x = (fr * uu - fu * ru) / whole, y = (fu * rr - fr * ru) / whole;
    return light.shape == PlanarLight::Shape::ellipse ? x * x + y * y < 1
                                                      : std::abs(x) < 1 && std::abs(y) < 1;
}

} // namespace

double area(const PlanarLight& light)
{
    const double rectangle =
        4 * glm::length(glm::cross(glm::dvec3(light.half_right), glm::dvec3(light.half_up)));
    return light.shape == PlanarLight::Shape::ellipse ? rectangle * (kPi / 4) : rectangle;
}

std::optional<LightSample> sample_li(const PlanarLight& light, const LightReceiver& at,
                                     RandomSequence& random)
{
    LightSample out;
    out.point = point_on(light, random.next2());
    const glm::vec3 way = out.point - at.position;
    const float distance2 = glm::dot(way, way);
    out.direction = way / std::sqrt(distance2);
    const float cosine = -glm::dot(out.direction, light.direction);
    const float share = cosine > 0 ? radiance_share(light.spread, cosine) : 0;
    if (!(share > 0))
        return std::nullopt;
    out.pdf = static_cast<float>(distance2 / (cosine * area(light)));
    out.light = share * light.radiance / out.pdf;
    return out;
}

std::optional<LightHit> intersect(const PlanarLight& light, const Ray& ray)
{
    const float cosine = -glm::dot(ray.direction, light.direction);
    const float share = cosine > 0 ? radiance_share(light.spread, cosine) : 0;
    if (!(share > 0))
        return std::nullopt;
    const float distance = -glm::dot(light.centre - ray.origin, light.direction) / cosine;
    if (!(distance > 0) || !holds(light, ray.origin + distance * ray.direction))
        return std::nullopt;
    return LightHit{distance, share * light.radiance,
                    static_cast<float>(double{distance} * distance / (cosine * area(light)))};
}

EmittedPath sample_emission(const PlanarLight& light, const PathPlace&, RandomSequence& random)
{
    EmittedPath out;
    out.ray.origin = point_on(light, random.next2());
    const glm::vec3 local = sample_direction(light.spread, random);
    out.ray.direction = Frame(light.direction).to_world(local);
    out.power = Rgb(power(light));
    out.radiance = radiance_share(light.spread, local.z) * light.radiance;
    return out;
}

EmittedPath sample_aimed_emission(const PlanarLight& light, const PathPlace&,
                                  const std::vector<TargetSphere>& targets, RandomSequence& random)
{
    EmittedPath out;
    out.ray.origin = point_on(light, random.next2());
    const AimedRay aimed =
        aim_from_point(targets, out.ray.origin, {light.direction, kPi / 2}, random);
    out.ray.direction = aimed.direction;
    const float cosine = std::max(0.0f, glm::dot(light.direction, aimed.direction));
    out.radiance = cosine > 0 ? radiance_share(light.spread, cosine) * light.radiance : Rgb(0);
    out.power = out.radiance * (static_cast<float>(area(light)) * cosine * aimed.weight);
    return out;
}

glm::dvec3 power(const PlanarLight& light)
{
    return glm::dvec3(light.radiance * static_cast<float>(kPi * area(light)));
}

std::optional<LightBounds> bounds(const PlanarLight& light)
{
    LightBounds out;
    for (const float right : {-1.0f, 1.0f})
        for (const float up : {-1.0f, 1.0f})
            out.box.add(light.centre + right * light.half_right + up * light.half_up);
    out.axis = light.direction;
    out.cos_reach = light.spread.cos_edge;
    out.power = light.spread.on_axis * max_channel(light.radiance) * area(light);
    return out;
}

} // namespace hipmap
