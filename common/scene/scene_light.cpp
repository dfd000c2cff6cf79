#include "common/scene/scene_light.h"

#include <cmath>

namespace hipmap {

namespace {

using std::numbers::pi;

/// From a rectangle or an ellipse; the factor is its area.
MeanEmission from_flat(bool is_disc, const glm::dvec3& centre, const glm::dvec3& half_right,
                       const glm::dvec3& half_up)
{
    MeanEmission out;
    out.from = is_disc ? MeanEmission::From::ellipse : MeanEmission::From::rectangle;
    out.centre = centre;
    out.half_right = half_right;
    out.half_up = half_up;
    out.factor = (is_disc ? pi : 4.0) * glm::length(glm::cross(half_right, half_up));
    return out;
}

} // namespace

MeanEmission mean_emission(const ScenePointLight& light)
{
    MeanEmission out;
    out.centre = light.position;
    out.radius = light.radius;
    out.light = light.intensity;
    out.factor = 4 * pi;
    return out;
}

MeanEmission mean_emission(const SceneSpotLight& light)
{
    MeanEmission out;
    out.centre = light.position;
    out.radius = light.radius;
    out.axis = light.direction;
    out.cos_reach = light.cos_inner - (light.cos_inner - light.cos_outer) / 3;
    out.light = light.intensity;
    out.factor = 2 * pi * (1 - out.cos_reach);
    return out;
}

MeanEmission mean_emission(const SceneSunLight& light)
{
    MeanEmission out;
    out.from = MeanEmission::From::afar;
    out.axis = light.direction;
    out.half_angle = light.half_angle;
    out.light = light.irradiance;
    return out;
}

MeanEmission mean_emission(const SceneAreaLight& light)
{
    MeanEmission out = from_flat(light.is_disc, light.centre, light.half_right, light.half_up);
    out.axis = light.direction;
    out.cos_reach = 0;
    out.by_cosine = true;
    out.light = light.radiance;
    out.factor *= pi;
    return out;
}

MeanEmission mean_emission(const SceneIesLight& light)
{
    const PhotometricWeb& web = light.web;
    const std::size_t rings = web.azimuth.size();
    std::vector<double> ring(web.polar.size(), 0.0);
    double sum = 0, weights = 0;
    for (std::size_t p = 0; p < ring.size(); ++p) {
        for (std::size_t a = 0; a < rings; ++a)
            ring[p] += web.candela[p * rings + a] / static_cast<double>(rings);
        sum += ring[p] * std::sin(web.polar[p]);
        weights += std::sin(web.polar[p]);
    }
    const double mean = weights > 0 ? sum / weights : 0;
    double reach = 0;
    for (std::size_t p = 0; p < ring.size(); ++p)
        if (ring[p] >= 0.1 * mean)
            reach = web.polar[p];
    MeanEmission out;
    out.centre = light.position;
    out.axis = light.direction;
    out.cos_reach = std::cos(reach);
    out.light = light.intensity;
    out.factor = mean * 2 * pi * (1 - std::cos(web.polar.back()));
    return out;
}

MeanEmission mean_emission(const SceneBeamLight& light)
{
    MeanEmission out =
        from_flat(light.is_disc, light.centre, light.right - light.centre, light.up - light.centre);
    out.axis = light.direction;
    out.cos_reach = 1;
    out.light = light.irradiance;
    return out;
}

} // namespace hipmap
