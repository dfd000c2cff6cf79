#include "render/lights/image_environment.h"

#include <limits>

namespace hipmap {

namespace {

/// Light along a direction drawn by the map.
struct DrawnLight : ParallelLight {
    float pdf = 0.0f; ///< per solid angle
};

DrawnLight draw(const ImageEnvironment& light, RandomSequence& random)
{
    const glm::vec3 from = sample_direction(*light.map, random.next2());
    const MapPoint point = at_direction(*light.map, from);
    return {{-from, point.pdf > 0 ? point.radiance / point.pdf : Rgb(0), point.radiance},
            point.pdf};
}

} // namespace

std::optional<LightSample> sample_li(const ImageEnvironment& light, const LightReceiver&,
                                     RandomSequence& random)
{
    const DrawnLight drawn = draw(light, random);
    if (!(drawn.pdf > 0))
        return std::nullopt;
    LightSample out;
    out.is_far = true;
    out.direction = -drawn.direction;
    out.pdf = drawn.pdf;
    out.light = drawn.irradiance;
    return out;
}

std::optional<LightHit> intersect(const ImageEnvironment& light, const Ray& ray)
{
    const MapPoint point = at_direction(*light.map, ray.direction);
    return LightHit{std::numeric_limits<float>::infinity(), point.radiance, point.pdf};
}

EmittedPath sample_emission(const ImageEnvironment& light, const PathPlace&, RandomSequence& random)
{
    return path_along(light.scene, draw(light, random), random);
}

PrimarySample primary_of(const ImageEnvironment& light, const Ray& ray, const PrimarySample& unused)
{
    return {direction_sample_of(*light.map, -ray.direction), disc_sample_of(light.scene, ray),
            unused[2], unused[3]};
}

EmittedPath sample_aimed_emission(const ImageEnvironment& light, const PathPlace&,
                                  const std::vector<TargetSphere>& targets, RandomSequence& random)
{
    return aimed_path_along(light.scene, draw(light, random), targets, random);
}

glm::dvec3 power(const ImageEnvironment& light)
{
    return double{light.scene.disc_area()} * light.map->flux;
}

double path_power(const ImageEnvironment& light)
{
    return light.scene.disc_area() * light.map->brightest_flux;
}

} // namespace hipmap
