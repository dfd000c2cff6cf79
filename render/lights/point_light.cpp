#include "render/lights/point_light.h"

#include "common/math/sampling.h"
#include "render/lights/point_sample.h"

namespace hipmap {

std::optional<LightSample> sample_li(const PointLight& light, const LightReceiver& at,
                                     RandomSequence&)
{
    return sample_point(light.position, at, [&](const glm::vec3&) { return light.intensity; });
}

EmittedPath sample_emission(const PointLight& light, const PathPlace&, RandomSequence& random)
{
    EmittedPath out;
    out.ray.origin = light.position;
    out.ray.direction = sample_sphere(random.next2());
    out.power = Rgb(power(light));
    return out;
}

EmittedPath sample_aimed_emission(const PointLight& light, const PathPlace&,
                                  const std::vector<TargetSphere>& targets, RandomSequence& random)
{
    const AimedRay aimed = aim_from_point(targets, light.position, {}, random);
    EmittedPath out;
    out.ray.origin = light.position;
    out.ray.direction = aimed.direction;
    out.power = light.intensity * aimed.weight;
    return out;
}

glm::dvec3 power(const PointLight& light)
{
    return glm::dvec3(light.intensity * (4 * kPi));
}

std::optional<LightBounds> bounds(const PointLight& light)
{
    LightBounds out;
    out.box.add(light.position);
    out.cos_spread = -1;
    out.power = max_channel(light.intensity);
    return out;
}

} // namespace hipmap
