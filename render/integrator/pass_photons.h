#pragma once

#include "render/integrator/render_options.h"

namespace hipmap {

struct PassMapSet {
    PhotonMaps caustic;
    PhotonMaps global;
};

/// What the photons of a pass are traced by.
PhotonOptions photon_options(const RenderOptions& options, std::uint64_t pass);

/// Traces photons and counts them.
TracedPhotons trace_pass(const RenderScene& scene, const PhotonOptions& options,
                         RenderStatistics& statistics);

/// Builds maps and counts them; `kind` is the part of the statistics that they belong to.
PhotonMaps build_maps(const RenderScene& scene, const std::vector<Photon>& photons,
                      const MapOptions& options, KindStatistics& kind,
                      RenderStatistics& statistics);

} // namespace hipmap
