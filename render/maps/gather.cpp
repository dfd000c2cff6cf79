#include "render/maps/gather.h"

#include <algorithm>
#include <numbers>

namespace hipmap {

Rgb gathered_power(const Photon& photon, const PhotonQuery& query)
{
    if (query.bsdf == nullptr)
        return photon.power;
    return photon.power *
           diffuse_shape(*query.bsdf, query.shading_normal, photon.direction, query.toward_eye);
}

Rgb projected_power(const Photon& photon, const PhotonQuery& query, const MapSurfaces& surfaces)
{
    const Rgb power = gathered_power(photon, query);
    if (photon.face == query.face)
        return power;
    const float cosine = glm::dot(surfaces.normals[photon.face], surfaces.normals[query.face]);
    return power * std::max(0.0f, cosine);
}

Rgb per_area(const Rgb& power, double area)
{
    if (!(area > 0))
        return Rgb(0);
    const Rgb out = power / static_cast<float>(area);
    return is_finite(out) ? out : Rgb(0);
}

double disc_area(float radius)
{
    return std::numbers::pi * (double{radius} * radius);
}

void look_around(const MapSurfaces& surfaces, const PhotonQuery& query, float radius,
                 EstimateScratch& scratch)
{
    scratch.segments.clear();
    surfaces.boundaries.near(surfaces.partition.map_of_face[query.face], query.position, radius,
                             scratch.segments);
    const glm::uvec3 c = surfaces.mesh.corners[query.face];
    const std::vector<glm::vec3>& p = surfaces.mesh.positions;
    scratch.disc.look({{p[c.x], p[c.y], p[c.z]}, query.position, radius}, scratch.segments);
}

} // namespace hipmap
