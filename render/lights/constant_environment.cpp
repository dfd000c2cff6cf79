#include "render/lights/constant_environment.h"

#include "common/math/sampling.h"

#include <limits>

namespace hipmap {

namespace {

/// W/m2 across a direction drawn evenly, divided by the pdf of the direction.
Rgb irradiance(const ConstantEnvironment& light)
{
    return light.radiance * (4 * kPi);
}

} // namespace

std::optional<LightHit> intersect(const ConstantEnvironment& light, const Ray&)
{
    return LightHit{std::numeric_limits<float>::infinity(), light.radiance, 0};
}

EmittedPath sample_emission(const ConstantEnvironment& light, const PathPlace&,
                            RandomSequence& random)
{
    const glm::vec3 direction = sample_sphere(random.next2());
    return path_along(light.scene, {direction, irradiance(light), light.radiance}, random);
}

PrimarySample primary_of(const ConstantEnvironment& light, const Ray& ray,
                         const PrimarySample& unused)
{
    return {sphere_sample_of(ray.direction), disc_sample_of(light.scene, ray), unused[2],
            unused[3]};
}

EmittedPath sample_aimed_emission(const ConstantEnvironment& light, const PathPlace&,
                                  const std::vector<TargetSphere>& targets, RandomSequence& random)
{
    const glm::vec3 direction = sample_sphere(random.next2());
    return aimed_path_along(light.scene, {direction, irradiance(light), light.radiance}, targets,
                            random);
}

glm::dvec3 power(const ConstantEnvironment& light)
{
    return double{light.scene.disc_area()} * (4.0 * kPi * glm::dvec3(light.radiance));
}

} // namespace hipmap
