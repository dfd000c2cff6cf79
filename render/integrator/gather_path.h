#pragma once

#include "common/math/random.h"
#include "render/integrator/eye_path.h"
#include "render/integrator/gather_radius.h"
#include "render/integrator/importons.h"
#include "render/integrator/placed_guides.h"
#include "render/maps/volume_map.h"
#include "render/shading/interaction.h"

namespace hipmap {

/// What final-gather rays do.
enum class GatherRays : std::uint8_t {
    end_in_photons,
    go_on,           ///< as paths: of the maps, only the caustic one and that of media are read
    look_for_lights, ///< and nothing more
};

/// The maps and lights that one pass gathers from.  Borrows everything.
struct GatherMaps {
    const RenderScene& scene;
    const MapSurfaces& surfaces;
    const ChosenMaps& caustic;  ///< of the pass
    const ChosenMaps& global;   ///< of the pass, direct photons too
    const ChosenMaps& indirect; ///< of the pass, weighed by weigh_bounces
    const FirstRadii& first;
    GatherScale scale = {};
    GatherRays rays = GatherRays::end_in_photons;
    const VolumeMap* volume = nullptr;   ///< of the pass, of radii shrunk; null: there are no media
    const PlacedGuides* guide = nullptr; ///< of final-gather rays; null: lobes draw them
    const PlacedGuides* sky = nullptr;   ///< by which environments are sampled; null: they are not
    const ChosenMaps* glossy = nullptr;  ///< of the pass, weighed by weigh_glossy; null: none
    int emissive_points = 1;             ///< sampled on emissive faces for gathered lobes
};

/// Scratch memory of one thread for gather paths.
struct GatherScratch {
    ChosenScratch caustic, global, indirect, glossy;
    Importons* importons = nullptr;               ///< to keep the queries of photons in
    std::vector<GatherRecord>* records = nullptr; ///< to keep what gather rays found in
};

/// Estimates of one radiance with the radius of the pass and with two narrower ones (kNarrowing),
/// from the same photons and rays, so that they differ by their bias and the noise of few photons.
using RadianceByRadius = std::array<Rgb, 3>;

/// Returns the radiance that arrives along an eye ray, W/(m2 sr), docs/light_transport.md (20): at
/// the first diffuse surface direct light by shadow rays, the caustic map, and one final-gather ray
/// to the next diffuse surface, where both maps are read, or which goes on from there (50).  Biased
/// by the maps' radii alone, which shrink from pass to pass.  May not be finite if the scene's
/// numbers overflow; the film drops such samples. Thread-safe.
RadianceByRadius trace_gather_path(const GatherMaps& maps, const Ray& ray, SeenLights seen,
                                   RandomSequence& random, GatherScratch& scratch);

} // namespace hipmap
