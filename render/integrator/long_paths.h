#pragma once

#include "render/integrator/pilot_team.h"
#include "render/integrator/pixel_samples.h"

#include <vector>

namespace hipmap {

/// Returns by pixel of the image, [height][width], the mean of the long paths of one sample of the
/// pixel and of those around it; empty: there are none, or no sun.  Depends on scene, seed and size
/// alone.  On all threads, each process of a team some rows; cost: 8 eye rays a pixel that are not
/// shaded, and 56 more near pixels that have long paths.
std::vector<LongPaths> measure_long_paths(const PictureJob& job, const PilotTeam& team);

} // namespace hipmap
