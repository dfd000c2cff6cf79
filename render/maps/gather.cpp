#include "render/maps/gather.h"

#include <algorithm>
#include <numbers>

namespace hipmap {

glm::dvec3 power_in_lobes(const MetPhoton& photon, const PhotonQuery& query)
{
    return glm::dvec3(photon.map.powers.of(photon.slot)) *
           glm::dvec3((*query.lobes)(photon.map.direction(photon.slot)));
}

glm::dvec3 projected_power(const MetPhoton& photon, const PhotonQuery& query,
                           const MapSurfaces& surfaces)
{
    const glm::dvec3 power = gathered_power(photon, query);
    const FaceId face = photon.map.faces[photon.slot];
    if (face == query.face)
        return power;
    const float cosine = glm::dot(surfaces.normals[face], surfaces.normals[query.face]);
    return power * double{std::max(0.0f, cosine)};
}

Rgb per_area(const PowerScale& scale, const glm::dvec3& sum, double area)
{
    if (!(area > 0))
        return Rgb(0);
    const Rgb out(scale.unit * sum / area);
    return is_finite(out) ? out : Rgb(0);
}

double disc_area(float radius)
{
    return std::numbers::pi * (double{radius} * radius);
}

float look_around(const MapSurfaces& surfaces, const PhotonQuery& query, float radius,
                  EstimateScratch& scratch)
{
    const MapId map = surfaces.partition.map_of_face[query.face];
    const float seen = outline_boundary(surfaces.boundaries,
                                        {map, query.position, surfaces.normals[query.face], radius},
                                        scratch.outline, scratch.segments);
    if (!(seen > 0))
        return 0;
    const glm::uvec3 c = surfaces.mesh.corners[query.face];
    const std::vector<glm::vec3>& p = surfaces.mesh.positions;
    scratch.disc.look({{p[c.x], p[c.y], p[c.z]}, query.position, seen}, scratch.segments);
    return seen;
}

} // namespace hipmap
