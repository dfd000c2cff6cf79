#include "render/maps/gather.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hipmap {

namespace {

/// Outlines the boundary that a copy has as its shared faces do, from where they are stored.
float outline_copied(const MapSurfaces& surfaces, const PhotonQuery& query, float radius,
                     EstimateScratch& scratch)
{
    const Similarity& place = surfaces.mesh.copy_of(query.face).place;
    const FaceId stored = surfaces.mesh.stored_face(query.face);
    const float stored_radius = static_cast<float>(radius / place.scale);
    if (!(stored_radius > 0) || !std::isfinite(stored_radius))
        return 0;
    const float seen = outline_boundary(surfaces.boundaries,
                                        {surfaces.partition.map_of_face[stored],
                                         glm::vec3(place.point_back(glm::dvec3(query.position))),
                                         surfaces.normals[stored], stored_radius},
                                        scratch.outline, scratch.segments);
    for (BoundarySegment& segment : scratch.segments)
        for (glm::vec3* end : {&segment.a, &segment.b})
            *end = glm::vec3(place.point(glm::dvec3(*end)));
    return seen == stored_radius ? radius
                                 : std::min(radius, static_cast<float>(seen * place.scale));
}

/// Writes the outline of all boundaries of the query's map to scratch.segments.
float outline_all(const MapSurfaces& surfaces, const PhotonQuery& query, float radius,
                  EstimateScratch& scratch)
{
    const MapId map = surfaces.partition.map_of(query.face);
    const auto outline = [&](const MapBoundaries& boundaries, MapId id, auto& out) {
        return outline_boundary(boundaries,
                                {id, query.position, surfaces.normal(query.face), radius},
                                scratch.outline, out);
    };
    const float seen = surfaces.mesh.is_copied(query.face)
                           ? outline_copied(surfaces, query, radius, scratch)
                           : outline(surfaces.boundaries, map, scratch.segments);
    const MapId own = surfaces.own_boundaries.place(map);
    if (own == kNone)
        return seen;
    const float seen_own = outline(surfaces.own_boundaries.boundaries, own, scratch.own);
    scratch.segments.insert(scratch.segments.end(), scratch.own.begin(), scratch.own.end());
    return std::min(seen, seen_own);
}

} // namespace

void gather_powers(const PhotonMap& map, std::span<const std::uint32_t> slots,
                   const PhotonQuery& query, PowerBatch& out)
{
    const auto write = [&](std::size_t i, const glm::dvec3& weight) {
        const PowerSum power = map.powers.of(slots[i]);
        for (int channel = 0; channel < 3; ++channel)
            out.of[i][channel] = static_cast<double>(power[channel]) * weight[channel];
        out.of[i][3] = 0;
    };
    if (query.lobes == nullptr) {
        for (std::size_t i = 0; i < slots.size(); ++i)
            write(i, glm::dvec3(1));
        return;
    }
    DirectionBatch in;
    RgbBatch weights;
    unpack_directions(map.directions, slots, in);
    query.lobes->weigh(in, slots.size(), weights);
    for (std::size_t i = 0; i < slots.size(); ++i)
        write(i, glm::dvec3(weights.at(i)));
}

double facing(const MetPhoton& photon, const PhotonQuery& query, const MapSurfaces& surfaces)
{
    const FaceId face = photon.map.faces[photon.slot];
    return face == query.face ? 1.0
                              : double{std::max(0.0f, glm::dot(surfaces.normal(face),
                                                               surfaces.normal(query.face)))};
}

bool is_on_side(const MetPhoton& photon, const PhotonQuery& query, const MapSurfaces& surfaces)
{
    const FaceId face = photon.map.faces[photon.slot];
    return face == query.face || glm::dot(surfaces.normal(face), surfaces.normal(query.face)) > 0;
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

FoldAreas gathered_areas(const MapSurfaces& surfaces, const PhotonQuery& query,
                         std::span<const float> radii, const EstimateScratch& scratch)
{
    const bool open = scratch.segments.empty();
    FoldAreas out{};
    for (std::size_t r = 0; r < radii.size(); ++r)
        out[r] = open || !(radii[r] > 0) ? disc_area(radii[r]) : scratch.disc.area(radii[r]);
    if (!surfaces.may_fold(query.face))
        return out;
    const FoldAreas facing = surfaces.facing_areas(query.face, query.position, radii,
                                                   open ? AreaOf::surface : AreaOf::projection);
    for (std::size_t r = 0; r < radii.size(); ++r)
        if (facing[r] > 0)
            out[r] = open ? facing[r] : std::min(out[r], facing[r]);
    return out;
}

float look_around(const MapSurfaces& surfaces, const PhotonQuery& query, float radius,
                  EstimateScratch& scratch)
{
    const float seen = outline_all(surfaces, query, radius, scratch);
    if (!(seen > 0))
        return 0;
    scratch.disc.look({surfaces.mesh.triangle(query.face), query.position, seen}, scratch.segments);
    return seen;
}

} // namespace hipmap
