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

/// What a frame of an animation keeps for the next one.  All frames are rendered with the same
/// options.
struct PreviousFrame {
    std::vector<Setting> settings; ///< all that its image depends on; empty: there was none
    std::optional<RenderedFrame> rendered;
    std::string world; ///< all that its photons depend on
    PhotonCache photons;
};

/// Returns the cache of photons for a frame of this scene; empties it if anything except the camera
/// has changed.  The cache fills in the first frame, and in a frame where only the camera has moved
/// since the previous one; while other things move, it uses no memory.
PhotonCache& cache_for(PreviousFrame& previous, const Scene& scene, const Partition& partition,
                       const EnvironmentMap& sky, double most_mib);

} // namespace hipmap
