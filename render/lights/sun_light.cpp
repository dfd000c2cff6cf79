#include "render/lights/sun_light.h"

#include "common/math/frame.h"
#include "render/lights/cone.h"

#include <cmath>
#include <limits>

namespace hipmap {

namespace {

float cone_height(const SunLight& light)
{
    const float sine = std::sin(0.5f * light.half_angle);
    return 2 * sine * sine;
}

/// Infinite for a sun without a size.
Rgb disc_radiance(const SunLight& light)
{
    const float sine = std::sin(light.half_angle);
    return light.irradiance / (kPi * sine * sine);
}

/// Even over the disc.
glm::vec3 draw_direction(const SunLight& light, RandomSequence& random)
{
    if (!(light.half_angle > 0))
        return light.direction;
    const glm::vec2 u = random.next2();
    return Frame(light.direction).to_world(direction_below_pole(cone_height(light) * u.x, u.y));
}

ParallelLight draw(const SunLight& light, RandomSequence& random)
{
    return {draw_direction(light, random), Rgb(power(light)) / light.scene.disc_area(),
            disc_radiance(light)};
}

} // namespace

std::optional<LightSample> sample_li(const SunLight& light, const LightReceiver&,
                                     RandomSequence& random)
{
    LightSample out;
    out.is_far = true;
    out.direction = -draw_direction(light, random);
    out.light = light.irradiance;
    if (light.half_angle > 0) {
        out.pdf = cone_pdf(cone_height(light));
        out.light = disc_radiance(light) / out.pdf;
    }
    return out;
}

std::optional<LightHit> intersect(const SunLight& light, const Ray& ray)
{
    if (!(light.half_angle > 0))
        return std::nullopt;
    const float height = cone_height(light);
    const glm::vec3 sine = glm::cross(light.direction, ray.direction); // steadier than the cosine
    const bool wide = light.half_angle > 0.1f;
    const float cosine = -glm::dot(light.direction, ray.direction);
    if (!(cosine > 0) ||
        !(wide ? 1 - cosine < height : glm::dot(sine, sine) < height * (2 - height)))
        return std::nullopt;
    return LightHit{std::numeric_limits<float>::infinity(), disc_radiance(light), cone_pdf(height)};
}

FarLight far_light(const SunLight& light)
{
    const double flux = max_channel(light.irradiance);
    return {-light.direction, flux, flux > 0 ? flux * max_channel(disc_radiance(light)) : 0};
}

EmittedPath sample_emission(const SunLight& light, const PathPlace&, RandomSequence& random)
{
    return path_along(light.scene, draw(light, random), random);
}

PrimarySample primary_of(const SunLight& light, const Ray& ray, const PrimarySample& unused)
{
    const glm::vec2 on_disc = disc_sample_of(light.scene, ray);
    if (!(light.half_angle > 0))
        return {on_disc, unused[1], unused[2], unused[3]};
    return {cone_sample_of(cone_height(light), Frame(light.direction).to_local(ray.direction)),
            on_disc, unused[2], unused[3]};
}

EmittedPath sample_aimed_emission(const SunLight& light, const PathPlace&,
                                  const std::vector<TargetSphere>& targets, RandomSequence& random)
{
    return aimed_path_along(light.scene, draw(light, random), targets, random);
}

glm::dvec3 power(const SunLight& light)
{
    // The disc sends a little more than passes through a plane across its middle.
    return glm::dvec3(light.irradiance * light.scene.disc_area() *
                      (2 / (1 + std::cos(light.half_angle))));
}

} // namespace hipmap
