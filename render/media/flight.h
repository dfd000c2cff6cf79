#pragma once

#include "common/math/random.h"
#include "common/scene/medium.h"

namespace hipmap {

/// What is left of light after `distance`, docs/media.md (3).  distance: scene units, may be
/// infinite.
Rgb transmitted(const Rgb& extinction, float distance);

/// Radiance that a glowing medium adds over `distance`, docs/media.md (5).
Rgb emitted_along(const Medium& medium, float distance);

/// How far light has come.
struct Flight {
    bool scattered = false;
    float distance = 0.0f; ///< of the scattering, or the limit
    Rgb weight{1.0f};      ///< what is to be multiplied with what was carried; of light scattered
                           ///<   with the scattering coefficient
};

/// Draws where light is scattered for the next time, or that it reaches `limit` first; without a
/// draw where the medium does not scatter.  carried: the channels it is weighed by, not negative;
/// the sum over the channels of what is carried never grows.  docs/media.md (4).
Flight sample_flight(const Medium& medium, float limit, const Rgb& carried, RandomSequence& random);

} // namespace hipmap
