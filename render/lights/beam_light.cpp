#include "render/lights/beam_light.h"

#include "common/math/sampling.h"

namespace hipmap {

namespace {

/// Where the ray that leads along the beam to a point crosses the plane of the light.
glm::vec3 start_of(const BeamLight& light, const glm::vec3& point)
{
    return point - glm::dot(point - light.shape.centre, light.direction) * light.direction;
}

} // namespace

BeamLight light_from(const SceneBeamLight& light, const SceneSphere&)
{
    const glm::vec3 centre(light.centre);
    return {{light.is_disc ? FlatShape::Outline::ellipse : FlatShape::Outline::rectangle, centre,
             glm::vec3(light.right - light.centre), glm::vec3(light.up - light.centre)},
            glm::vec3(light.direction),
            Rgb(light.irradiance)};
}

std::optional<LightSample> sample_li(const BeamLight& light, const LightReceiver& at,
                                     RandomSequence&)
{
    LightSample out;
    out.direction = -light.direction;
    out.point = start_of(light, at.position);
    out.light = light.irradiance;
    const bool before = glm::dot(at.position - light.shape.centre, light.direction) > 0;
    return before && holds(light.shape, out.point) ? std::optional(out) : std::nullopt;
}

EmittedPath sample_emission(const BeamLight& light, const PathPlace&, RandomSequence& random)
{
    EmittedPath out;
    out.ray.origin = point_on(light.shape, random.next2());
    out.ray.direction = light.direction;
    out.power = Rgb(power(light));
    return out;
}

EmittedPath sample_aimed_emission(const BeamLight& light, const PathPlace& path,
                                  const std::vector<TargetSphere>& targets, RandomSequence& random)
{
    double area_of_targets = 0;
    for (const TargetSphere& target : targets)
        area_of_targets += kPi * double{target.radius} * target.radius;
    if (area(light.shape) <= area_of_targets)
        return sample_emission(light, path, random);
    const AimedPoint aimed = aim_parallel(targets, light.direction, random);
    EmittedPath out;
    out.ray.origin = start_of(light, aimed.position);
    out.ray.direction = light.direction;
    if (holds(light.shape, out.ray.origin))
        out.power = light.irradiance * aimed.weight;
    return out;
}

glm::dvec3 power(const BeamLight& light)
{
    return glm::dvec3(light.irradiance) * area(light.shape);
}

std::optional<LightBounds> bounds(const BeamLight& light)
{
    LightBounds out;
    out.box = bounds(light.shape);
    out.axis = light.direction;
    out.cos_reach = 1 - 1e-6f; // rounded outward
    out.power = max_channel(light.irradiance) * area(light.shape);
    return out;
}

} // namespace hipmap
