#pragma once

#include "render/integrator/photon_cache.h"
#include "render/integrator/run_passes.h"
#include "render/lights/environment_map.h"

#include <string>

namespace hipmap {

/// An image and how it was made.
struct RenderedFrame {
    RenderState state;
    RunResult result;
    RenderStatistics statistics;
    double seconds_rays = 0; ///< building the ray tracing structure
};

/// What a frame of an animation leaves to the next one.  All frames are rendered by the same
/// options.
struct PreviousFrame {
    std::vector<Setting> settings; ///< all that its image depends on; empty: there was none
    std::optional<RenderedFrame> rendered;
    std::string world; ///< all that its photons depend on
    PhotonCache photons;
};

/// Keeps the cache of photons for a frame of this scene, or empties it if anything but the camera
/// has changed.  It takes photons up in the first frame, and in one where nothing else has moved
/// since the frame before: if things go on moving, no memory is spent.
PhotonCache& cache_for(PreviousFrame& previous, const Scene& scene, const Partition& partition,
                       const EnvironmentMap& sky, double most_mib);

} // namespace hipmap
