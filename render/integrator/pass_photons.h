#pragma once

#include "common/stopwatch.h"
#include "render/integrator/pilot_team.h"
#include "render/integrator/render_options.h"

namespace hipmap {

/// The maps of one pass, with a volume map if the scene has media.
struct PassMapSet {
    ChosenMaps caustic;
    ChosenMaps global;
    std::optional<VolumeMap> volume;
};

/// A scene at some moment, and its faces as maps see them.
struct MappedScene {
    const RenderScene& scene;
    const MapSurfaces& surfaces;
};

/// Returns the options for tracing the photons of a pass.
PhotonOptions photon_options(const RenderScene& scene, const RenderOptions& options,
                             std::uint64_t pass);

/// Makes the light paths of a pass guided.  guides: borrowed; null: they start by power.
void guide(const PhotonGuides* guides, PhotonOptions& photons);

/// Returns for how many times as many neighbours guided photons of a kind are looked where no
/// gather rays average over the estimates.  They are denser: that is shared out between less noise
/// and less bias, docs/light_transport.md (41).
double neighbours_by(const PhotonGuides* guides, EmissionGuide PhotonGuides::*kind);

/// Keeps what guides promise.  guides: null: there are none.
void count_guides(const PhotonGuides* guides, RenderStatistics& statistics);

/// Returns the radii of volume photons, from pilot photons, docs/media.md (9).
VolumeRadii volume_radii(const RenderScene& scene, const TracedPhotons& pilot,
                         const RenderOptions& options);

/// Builds the volume map of a pass; none if the scene has no media.
std::optional<VolumeMap> build_volume(const RenderScene& scene, const TracedPhotons& traced,
                                      const VolumeRadii& first, float shrink);

/// Traces photons and counts them.
TracedPhotons trace_pass(const RenderScene& scene, const PhotonOptions& options,
                         RenderStatistics& statistics);

/// Traces the photons of a pilot, each process of a team a part of them.  Returns the photons of
/// all processes, the same as without a team.  The counts of the result cover only the paths that
/// this process traced, and BouncedPhoton::from is undefined.
TracedPhotons trace_together(const RenderScene& scene, const PhotonOptions& options,
                             const PilotTeam& team);

/// Returns whether irradiance is precomputed where gather rays end; it is Lambert's alone.
bool precomputes(const RenderScene& scene, const RenderOptions& options);

/// Returns what is asked of maps that gather rays do not end in.
DissertationOptions estimated(const RenderOptions& options);

/// Returns what is asked of the maps that gather rays end in.
DissertationOptions gathered(const RenderScene& scene, const RenderOptions& options);

/// What is asked of the maps of one kind of photon.
struct MapRequest {
    const MapOptions& options;
    const DissertationOptions& asked;
    ChosenMaps* previous = nullptr; ///< as build_chosen_maps has it
};

/// Builds maps and counts them.  Maps of several kinds may be built at the same time.
ChosenMaps build_maps(const MappedScene& mapped, const std::vector<Photon>& photons,
                      const MapRequest& request, KindStatistics& kind);

/// Counts all maps of a pass together.  watch: started when the first map was begun.
void count_maps(const std::optional<VolumeMap>& volume, const Stopwatch& watch,
                RenderStatistics& statistics);

} // namespace hipmap
