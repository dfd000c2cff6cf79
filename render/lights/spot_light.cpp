#include "render/lights/spot_light.h"

#include "render/lights/point_sample.h"

#include <cmath>

namespace hipmap {

std::optional<LightSample> sample_li(const SpotLight& light, const LightReceiver& at,
                                     RandomSequence&)
{
    return sample_point(light.position, at, [&](const glm::vec3& direction) {
        return light.intensity * falloff(light.cone, direction);
    });
}

EmittedPath sample_emission(const SpotLight& light, const PathPlace&, RandomSequence& random)
{
    EmittedPath out;
    out.ray.origin = light.position;
    out.ray.direction = sample_direction(light.cone, random);
    out.power = Rgb(power(light));
    return out;
}

EmittedPath sample_aimed_emission(const SpotLight& light, const PathPlace&,
                                  const std::vector<TargetSphere>& targets, RandomSequence& random)
{
    const LightCone cone{light.cone.direction, std::acos(light.cone.cos_outer)};
    const AimedRay aimed = aim_from_point(targets, light.position, cone, random);
    EmittedPath out;
    out.ray.origin = light.position;
    out.ray.direction = aimed.direction;
    out.power = light.intensity * falloff(light.cone, aimed.direction) * aimed.weight;
    return out;
}

glm::dvec3 power(const SpotLight& light)
{
    return glm::dvec3(light.intensity * falloff_integral(light.cone));
}

std::optional<LightBounds> bounds(const SpotLight& light)
{
    LightBounds out;
    out.box.add(light.position);
    out.axis = light.cone.direction;
    out.cos_reach = light.cone.cos_outer;
    out.power = max_channel(light.intensity);
    return out;
}

} // namespace hipmap
