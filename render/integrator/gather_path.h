#pragma once

#include "common/math/random.h"
#include "render/integrator/eye_path.h"
#include "render/integrator/gather_radius.h"
#include "render/integrator/importons.h"
#include "render/integrator/placed_guides.h"
#include "render/integrator/shared_gathers.h"
#include "render/maps/volume_map.h"
#include "render/shading/interaction.h"

namespace hipmap {

/// What final-gather rays do.
enum class GatherRays : std::uint8_t {
    end_in_photons,
    go_on,           ///< as paths: of the maps, only the caustic one and that of media are read
    look_for_lights, ///< and nothing more
};

/// Returns what they do in an image.
GatherRays gather_rays(const RenderOptions& options);

/// Returns whether pixels of an image share what gather rays find.  Nothing is shared where media
/// scatter, emit or fill the scene, or where faces let a part of the light through.
bool shares_gathers(const RenderScene& scene, const RenderOptions& options);

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
    bool shares = false;                          ///< starts are kept, and ends in them
    std::size_t sample = 0;                       ///< of the rows: the next one
    std::vector<GatherStart> starts;

    /// Adds what the searches did.
    void count(RenderStatistics& statistics) const
    {
        statistics.caustic.add_searches(caustic);
        statistics.global.add_searches(global);
        statistics.indirect.add_searches(indirect);
        statistics.glossy.add_searches(glossy);
    }
};

/// Returns the radiance that arrives along an eye ray, W/(m2 sr), docs/light_transport.md (20): at
/// the first diffuse surface direct light by shadow rays, the caustic map, and one final-gather ray
/// to the next diffuse surface, where both maps are read, or which goes on from there (50).  Biased
/// by the maps' radii alone, which shrink from pass to pass.  May not be finite if the scene's
/// numbers overflow; the film drops such samples. Thread-safe.
RadianceByRadius trace_gather_path(const GatherMaps& maps, const Ray& ray, SeenLights seen,
                                   RandomSequence& random, GatherScratch& scratch);

} // namespace hipmap
