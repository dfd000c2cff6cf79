#pragma once

#include "common/stopwatch.h"
#include "render/film/fireflies.h"
#include "render/integrator/missed_light.h"
#include "render/integrator/photon_cache.h"
#include "render/integrator/run_passes.h"
#include "render/layers/layer.h"
#include "render/lights/environment_map.h"
#include "render/quoted_change.h"

#include <optional>
#include <set>
#include <string>

namespace hipmap {

/// An image and how it was made.
struct RenderedFrame {
    RenderState state;
    RunResult result;
    RenderStatistics statistics;
    Spent rays;                     ///< building the ray tracing structure
    Spent pilots;                   ///< what the passes share, found before the first
    std::vector<LayerImage> layers; ///< of surfaces, those that were requested
    ShownFireflies fireflies;
    MissedLight missed;
    std::string unseen;                   ///< the light that most unseen light may be of
    std::vector<std::string> unreachable; ///< lights whose caustics no path from the eye finds
    std::string seen;                     ///< of a black image: what the camera looks at
    std::optional<Quote> quote;           ///< what other settings would cost; with --quote
    std::uint64_t resumed = 0;            ///< passes that a state or the previous frame had
};

/// Returns the seconds of what a frame takes once, whatever the number of its passes.
inline double seconds_before_passes(const RenderedFrame& frame)
{
    return frame.rays.seconds + frame.pilots.seconds;
}

/// Where a frame stands among all frames of a run.
struct FramePlace {
    int done = 0;               ///< frames before it
    int all = 1;                ///< frames of the run
    int ready = 0;              ///< those of them that took no passes
    double ready_seconds = 0;   ///< that these took
    double begun = 0;           ///< s, when the frame under way began
    const Stopwatch watch{};    ///< since the first began
    std::set<std::string> told; ///< sentences of the audit that frames have printed
    double low = 0, high = 0;   ///< least and largest estimated error so far

    /// Returns the time that all frames have left, `share` of the one under way being done; none:
    /// unknown.
    std::optional<double> seconds_left(double share) const;
    /// Ends the frame under way.  took_passes: false if all its passes were there before.
    void end_frame(bool took_passes);
    /// Returns "frame 3 of 24".
    std::string text() const;
};

/// What a frame of an animation keeps for the next one.  All frames are rendered with the same
/// options.
struct PreviousFrame {
    FramePlace place;
    std::vector<Setting> settings; ///< all that its image depends on; empty: there was none
    std::optional<RenderedFrame> rendered;
    std::string world; ///< all that its photons depend on
    PhotonCache photons;
};

/// Returns the place of a frame among others; null: it is the only one of the run.
FramePlace* place_of(PreviousFrame* previous);

/// Returns the cache of photons for a frame of this scene.  If anything except the camera has
/// changed, the frame makes its own photons, and takes over the maps whose photons are the same.
PhotonCache& cache_for(PreviousFrame& previous, const Scene& scene, const Partition& partition,
                       const EnvironmentMap& sky, double most_mib);

} // namespace hipmap
