#pragma once

#include "common/math/random.h"
#include "common/scene/medium.h"

namespace hipmap {

/// What is left of light after `column` (that of the distance, where the density is 1),
/// docs/media.md (3) and (11).  column: scene units, may be infinite.
Rgb transmitted(const Rgb& extinction, float column);

/// Radiance that a glowing medium adds over `column`, docs/media.md (5).
Rgb emitted_along(const Medium& medium, float column);

/// How far light has come.
struct Flight {
    bool scattered = false;
    float column = 0.0f; ///< up to the scattering, or the limit
    Rgb weight{1.0f};    ///< what is to be multiplied with what was carried; of light scattered
                         ///<   with the scattering coefficient
};

/// Draws where light is scattered for the next time, or that it reaches the column `limit` first;
/// without a draw where the medium does not scatter.  carried: the channels it is weighed by, not
/// negative; the sum over the channels of what is carried never grows.  docs/media.md (4).
Flight sample_flight(const Medium& medium, float limit, const Rgb& carried, RandomSequence& random);

} // namespace hipmap
