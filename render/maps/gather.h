#pragma once

#include "render/maps/estimate.h"
#include "render/shading/lobe_batch.h"

#include <algorithm>

namespace hipmap {

/// A photon as an estimate reads it.
struct MetPhoton {
    const PhotonMap& map;
    std::uint32_t slot;
};

/// What photons add to the sum of an estimate, in units of the maps' scale: red, green, blue, 0.
struct alignas(32) PowerBatch {
    double of[kBatch][4];

    glm::dvec3 at(std::size_t i) const { return {of[i][0], of[i][1], of[i][2]}; }
};

/// Writes what 1 to kBatch photons of a map add to the sum of an estimate: their powers, weighted
/// by the query's lobes if it names any.
void gather_powers(const PhotonMap& map, std::span<const std::uint32_t> slots,
                   const PhotonQuery& query, PowerBatch& out);

/// Calls use(batch) for at most kBatch slots at a time, in their order.
template <typename Use>
void for_each_batch(std::span<const std::uint32_t> slots, const Use& use)
{
    for (; !slots.empty(); slots = slots.subspan(std::min(kBatch, slots.size())))
        use(slots.first(std::min(kBatch, slots.size())));
}

/// Calls use(slot, power) for each photon in turn, with what it adds to the sum of an estimate.
template <typename Use>
void for_each_power(const PhotonMap& map, std::span<const std::uint32_t> slots,
                    const PhotonQuery& query, const Use& use)
{
    PowerBatch powers;
    for_each_batch(slots, [&](std::span<const std::uint32_t> batch) {
        gather_powers(map, batch, query, powers);
        for (std::size_t i = 0; i < batch.size(); ++i)
            use(batch[i], powers.at(i));
    });
}

/// Returns the cosine between the faces of a photon and of the query, at least 0: the factor of its
/// power in the plane of the query's face, docs/photon_maps.md (4).
double facing(const MetPhoton& photon, const PhotonQuery& query, const MapSurfaces& surfaces);

/// Returns whether the face of a photon looks to the same side as the query's, docs/visible_area.md
/// (A8).
bool is_on_side(const MetPhoton& photon, const PhotonQuery& query, const MapSurfaces& surfaces);

/// Converts a sum in units of the scale into W/m2.  Zero where the area is not above zero or the
/// quotient is not finite.
Rgb per_area(const PowerScale& scale, const glm::dvec3& sum, double area);

/// Returns pi r^2, square scene units.
double disc_area(float radius);

/// Returns the area that photons within each radius are divided by, square scene units: that of the
/// disc that look_around has set up in scratch, or less on a map that folds, docs/visible_area.md
/// (A9).  radii: at most three, >= 0, finite.
FoldAreas gathered_areas(const MapSurfaces& surfaces, const PhotonQuery& query,
                         std::span<const float> radii, const EstimateScratch& scratch);

/// Sets up scratch.disc with the boundaries of the query's map within the radius (> 0, finite);
/// scratch.segments stays empty if none is near.  Returns the radius out to which the disc may be
/// used: the given one, or less where the boundary is too dense for it; 0: none.
float look_around(const MapSurfaces& surfaces, const PhotonQuery& query, float radius,
                  EstimateScratch& scratch);

} // namespace hipmap
