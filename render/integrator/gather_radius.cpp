#include "render/integrator/gather_radius.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace hipmap {

namespace {

PhotonQuery query_at(const Photon& photon, const MapSurfaces& surfaces)
{
    const glm::vec3& up = surfaces.normals[photon.face];
    return {photon.position, photon.side == 0 ? up : -up, photon.face, photon.side};
}

} // namespace

float first_radius(const PhotonMaps& pilot, const MapSurfaces& surfaces, PhotonQuery query,
                   SearchScratch& scratch)
{
    const MapId id = surfaces.partition.map_of_face[query.face];
    if (id == kNone)
        return std::numeric_limits<float>::infinity();
    query.radius = even_radius(pilot, surfaces.partition, query);
    if (!std::isfinite(query.radius)) // no photon: as if there were one
        return filter_radius(surfaces.map_area[id], pilot.options.neighbours, 1);
    const FoundPhotons found =
        find_photons(pilot, surfaces.mesh, surfaces.partition, query, scratch);
    return found.slots.size() == pilot.options.neighbours ? std::sqrt(found.farthest2)
                                                          : query.radius;
}

float gather_weight(float radius_at_y, float radius_at_x)
{
    const float y2 = radius_at_y * radius_at_y, x2 = radius_at_x * radius_at_x;
    return x2 > 0 && std::isfinite(x2) && std::isfinite(y2) ? y2 / (y2 + x2) : 1.0f;
}

std::vector<Photon> weigh_bounces(const TracedPhotons& traced, const PilotMaps& pilot,
                                  const MapSurfaces& surfaces)
{
    std::vector<Photon> out(traced.bounces.size());
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, out.size()),
        [&](const tbb::blocked_range<std::size_t>& range) {
            SearchScratch at_y, at_x;
            for (std::size_t i = range.begin(); i < range.end(); ++i) {
                const BouncedPhoton& bounced = traced.bounces[i];
                const Photon& from =
                    (bounced.from_caustic ? traced.caustic : traced.global)[bounced.from];
                const float y = first_radius(bounced.from_caustic ? pilot.caustic : pilot.global,
                                             surfaces, query_at(from, surfaces), at_y);
                const float x = first_radius(pilot.indirect, surfaces,
                                             query_at(bounced.photon, surfaces), at_x);
                out[i] = bounced.photon;
                out[i].power *= 1 - gather_weight(y, x);
            }
        });
    return out;
}

} // namespace hipmap
