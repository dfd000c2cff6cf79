#pragma once

#include "render/maps/radius_field.h"
#include "render/photons/trace_photons.h"
#include "render/shading/interaction.h"

#include <cstdint>

namespace hipmap {

/// The radii of the first pass, from pilot photons that are never summed: an estimate must not
/// depend on the photons that are summed within its radius.  docs/photon_maps.md (10).
struct FirstRadii {
    RadiusField caustic, global, indirect, glossy;
    float glossy_power = 0; ///< mean of the glossy photons' largest channels
};

/// Returns the query of photons where one lies.
PhotonQuery query_at(const Photon& photon, const MapSurfaces& surfaces);

/// Light that goes from a diffuse surface at y to the diffuse surface at x.
struct Bounce {
    float radius_at_y = 0; ///< the first radii
    float radius_at_x = 0;
    float distance2 = 0;      ///< square, from y to x
    bool by_specular = false; ///< specular or followed lobes have sent it on between
};

/// The gather rays that count in the weights of a pass, and its radius over the first one.
struct GatherScale {
    float rays = 1;
    float shrink = 1;
    float samples = 1; ///< of a pixel in the pass, on average
};

/// Returns the scale of a pass.  A gather ray counts for less than one: all photons that it reads
/// share its direction, so that together they tell less than as many photons that came by ways of
/// their own.  docs/light_transport.md (42).  samples: gather rays of a pixel in the pass, on
/// average.  neighbours: photons within the first radius of the maps that they read.
GatherScale gather_scale(float samples, float shrink, std::uint32_t neighbours);

/// Returns the weight of final gathering against direct photons.  The light of a bounce is found in
/// two ways: by the final-gather ray from x that reads a map at y, and by the photon that continued
/// from y to x.  Both are weighted by how much each finds, and the second by how little its radius
/// blurs, docs/light_transport.md (21), (42); the weight of the first is 1 if there is no second
/// (radius_at_x zero or not finite).
float gather_weight(const Bounce& bounce, const GatherScale& scale);

/// Returns how many photons lie on average around a point of a glossy surface, for each sample of
/// its pixel, by GlossyPhoton::radiance in W/m2, docs/light_transport.md (44).  radius: the first
/// one there; infinite: none do.
float glossy_density(const FirstRadii& first, float radius, const GatherScale& scale);

/// Returns how many photons the rays that followed lobes send from a surface compete with, by the
/// cosine of the ray and the radiance of what it meets; 0: none.  radius: as in glossy_density.
float photons_against_rays(const FirstRadii& first, float radius, const GatherScale& scale,
                           const Interaction& at);

/// The photons with which the rays of followed lobes share light in a pass.  Borrows everything.
struct GlossyRivals {
    const FirstRadii* first = nullptr; ///< null: there are no such photons
    const MapSurfaces* surfaces = nullptr;
    GatherScale scale = {};
};

/// Returns the same number by the photons of a pass, whose first radius at the surface it looks up;
/// 0 without such photons.
float photons_against_rays(const GlossyRivals& rivals, const Interaction& at);

/// Returns the glossy photons with their powers multiplied by what rays leave to them.  In
/// parallel.
std::vector<Photon> weigh_glossy(const TracedPhotons& traced, const FirstRadii& first,
                                 const MapSurfaces& surfaces, const GatherScale& scale);

/// Returns the bounced photons with their powers multiplied by 1 - gather_weight.  In parallel.
std::vector<Photon> weigh_bounces(const TracedPhotons& traced, const FirstRadii& first,
                                  const MapSurfaces& surfaces, const GatherScale& scale);

} // namespace hipmap
