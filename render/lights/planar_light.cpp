#include "render/lights/planar_light.h"

#include "common/math/frame.h"
#include "common/math/sampling.h"

#include <algorithm>
#include <cmath>

namespace hipmap {

std::optional<LightSample> sample_li(const PlanarLight& light, const LightReceiver& at,
                                     RandomSequence& random)
{
    LightSample out;
    out.point = point_on(light.shape, random.next2());
    const glm::vec3 way = out.point - at.position;
    const float distance2 = glm::dot(way, way);
    out.direction = way / std::sqrt(distance2);
    const float cosine = -glm::dot(out.direction, light.direction);
    const float share = cosine > 0 ? radiance_share(light.spread, cosine) : 0;
    if (!(share > 0))
        return std::nullopt;
    out.pdf = static_cast<float>(distance2 / (cosine * area(light.shape)));
    out.light = share * light.radiance / out.pdf;
    return out;
}

std::optional<LightHit> intersect(const PlanarLight& light, const Ray& ray)
{
    const float cosine = -glm::dot(ray.direction, light.direction);
    const float share = cosine > 0 ? radiance_share(light.spread, cosine) : 0;
    if (!(share > 0))
        return std::nullopt;
    const float distance = -glm::dot(light.shape.centre - ray.origin, light.direction) / cosine;
    if (!(distance > 0) || !holds(light.shape, ray.origin + distance * ray.direction))
        return std::nullopt;
    return LightHit{distance, share * light.radiance,
                    static_cast<float>(double{distance} * distance / (cosine * area(light.shape)))};
}

EmittedPath sample_emission(const PlanarLight& light, const PathPlace&, RandomSequence& random)
{
    EmittedPath out;
    out.ray.origin = point_on(light.shape, random.next2());
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
    out.ray.origin = point_on(light.shape, random.next2());
    const AimedRay aimed =
        aim_from_point(targets, out.ray.origin, {light.direction, kPi / 2}, random);
    out.ray.direction = aimed.direction;
    const float cosine = std::max(0.0f, glm::dot(light.direction, aimed.direction));
    out.radiance = cosine > 0 ? radiance_share(light.spread, cosine) * light.radiance : Rgb(0);
    out.power = out.radiance * (static_cast<float>(area(light.shape)) * cosine * aimed.weight);
    return out;
}

glm::dvec3 power(const PlanarLight& light)
{
    return glm::dvec3(light.radiance * static_cast<float>(kPi * area(light.shape)));
}

std::optional<LightBounds> bounds(const PlanarLight& light)
{
    LightBounds out;
    out.box = bounds(light.shape);
    out.axis = light.direction;
    out.cos_reach = light.spread.cos_edge;
    out.power = light.spread.on_axis * max_channel(light.radiance) * area(light.shape);
    return out;
}

} // namespace hipmap
