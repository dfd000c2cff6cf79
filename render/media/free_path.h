#pragma once

#include "common/math/random.h"
#include "common/scene/medium.h"

namespace hipmap {

/// What is left of light after `optical_depth` (that of the distance, where the pdf is 1),
/// docs/media.md (3) and (11).  optical_depth: scene units, may be infinite.
Rgb transmitted(const Rgb& extinction, float optical_depth);

/// Radiance that a emissive medium adds over `optical_depth`, docs/media.md (5).
Rgb emitted_along(const Medium& medium, float optical_depth);

/// How far light has come.
struct FreePath {
    bool scattered = false;
    float optical_depth = 0.0f; ///< up to the scattering, or the limit
    Rgb weight{1.0f}; ///< what is to be multiplied with what was carried; of light scattered
                      ///<   with the scattering coefficient
};

/// Draws where light is scattered for the next time, or that it reaches the optical_depth `limit`
/// first; without a draw where the medium does not scatter.  carried: the channels it is weighed
/// by, not negative; the sum over the channels of what is carried never grows.  docs/media.md (4).
FreePath sample_free_path(const Medium& medium, float limit, const Rgb& carried,
                          RandomSequence& random);

} // namespace hipmap
