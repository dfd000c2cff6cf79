#include "render/integrator/gather_radius.h"

#include "render/integrator/gather_branch.h"
#include "render/maps/gather.h"
#include "render/shading/scatter.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>

namespace hipmap {

PhotonQuery query_at(const Photon& photon, const MapSurfaces& surfaces)
{
    const glm::vec3 up = surfaces.normal(photon.face);
    return {photon.position, photon.side == 0 ? up : -up, photon.face, photon.side};
}

GatherScale gather_scale(float samples, float shrink, std::uint32_t neighbours)
{
    constexpr float kUnshared = 50; // photons from which on a ray counts less than half
    const float photons = static_cast<float>(neighbours) * shrink * shrink;
    return {samples / (1 + photons / kUnshared), shrink, samples};
}

float gather_weight(const Bounce& bounce, const GatherScale& scale)
{
    constexpr float kSpecularRays = 8; // that count as one straight ray
    const float rays = bounce.by_specular ? scale.rays / kSpecularRays : scale.rays;
    const float y2 = rays * bounce.radius_at_y * bounce.radius_at_y;
    const float x2 = bounce.radius_at_x * bounce.radius_at_x;
    // The more passes, the less noise is in the mean of all and the more the blur of each counts.
    const float shrink2 = scale.shrink * scale.shrink;
    const float blur2 = x2 / (shrink2 * shrink2);
    const float clear = bounce.distance2 / (bounce.distance2 + blur2);
    const float found2 = x2 * clear * clear;
    return found2 > 0 && std::isfinite(x2) && std::isfinite(y2) ? y2 / (y2 + found2) : 1.0f;
}

float glossy_density(const FirstRadii& first, float radius, const GatherScale& scale)
{
    if (!std::isfinite(radius) || !(first.glossy_power > 0))
        return 0;
    return static_cast<float>(disc_area(scale.shrink * radius)) /
           (first.glossy_power * scale.samples);
}

float photons_against_rays(const FirstRadii& first, float radius, const GatherScale& scale,
                           const Interaction& at)
{
    return glossy_density(first, radius, scale) / followed_peak(at);
}

float photons_against_rays(const GlossyRivals& rivals, const Interaction& at)
{
    if (rivals.first == nullptr)
        return 0;
    const float radius = radius_at(rivals.first->glossy, *rivals.surfaces, query_at(at));
    return photons_against_rays(*rivals.first, radius, rivals.scale, at);
}

std::vector<Photon> weigh_glossy(const TracedPhotons& traced, const FirstRadii& first,
                                 const MapSurfaces& surfaces, const GatherScale& scale)
{
    std::vector<Photon> out(traced.glossy.size());
    tbb::parallel_for(std::size_t{0}, out.size(), [&](std::size_t i) {
        const auto& [photon, radiance] = traced.glossy[i];
        const float radius = radius_at(first.glossy, surfaces, query_at(photon, surfaces));
        const float density = glossy_density(first, radius, scale) * radiance;
        out[i] = photon;
        if (std::isfinite(density))
            out[i].power *= density / (1 + density);
    });
    return out;
}

std::vector<Photon> weigh_bounces(const TracedPhotons& traced, const FirstRadii& first,
                                  const MapSurfaces& surfaces, const GatherScale& scale)
{
    std::vector<Photon> out(traced.bounces.size());
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, out.size()),
        [&](const tbb::blocked_range<std::size_t>& range) {
            for (std::size_t i = range.begin(); i < range.end(); ++i) {
                const BouncedPhoton& bounced = traced.bounces[i];
                out[i] = bounced.photon;
                if (bounced.from == kNoPhoton) // gather rays do not find what media scatter
                    continue;
                const Photon& from =
                    (bounced.from_caustic ? traced.caustic : traced.global)[bounced.from];
                const float y = radius_at(bounced.from_caustic ? first.caustic : first.global,
                                          surfaces, query_at(from, surfaces));
                const float x =
                    radius_at(first.indirect, surfaces, query_at(bounced.photon, surfaces));
                const glm::vec3 way = bounced.photon.position - from.position;
                out[i].power *=
                    1 - gather_weight({y, x, glm::dot(way, way), bounced.by_specular}, scale);
            }
        });
    return out;
}

} // namespace hipmap
