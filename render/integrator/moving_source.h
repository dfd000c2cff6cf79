#pragma once

#include "render/integrator/coarse_image.h"
#include "render/integrator/pass_source.h"

namespace hipmap {

/// A scene while a shutter is open.
struct MovingScene {
    const RenderScene& still; ///< at some moment: what pilots see, and whose partition is known
    std::function<Scene(double share)> at; ///< after that share, 0 to 1, of the time; same faces
};

/// Returns the share of the shutter time at which a pass sees the scene, in [0, 1): stratified over
/// the passes of a batch, independent between batches, docs/error.md (15).
double shutter_share(std::uint64_t seed, std::uint64_t pass);

/// Makes the integrator that the options name, with the photons and eye rays of each pass at one
/// moment, so that the mean of the passes is the mean over the shutter time, docs/animation.md.
/// Borrows and counts as make_pass_source does.  Each pass also builds its RenderScene.
PassSource make_moving_source(const MovingScene& moving, const RenderOptions& options,
                              RenderStatistics& statistics, const PilotControl& pilots = {});

} // namespace hipmap
