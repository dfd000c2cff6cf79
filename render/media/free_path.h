#pragma once

#include "common/math/random.h"
#include "common/scene/medium.h"

namespace hipmap {

/// Returns the transmittance after an optical depth (the path length times the density; extinction
/// is per unit of density), docs/media.md (3) and (11).  optical_depth: scene units, may be
/// infinite.
Rgb transmitted(const Rgb& extinction, float optical_depth);

/// Returns the radiance that an emissive medium adds over an optical depth, docs/media.md (5).
Rgb emitted_along(const Medium& medium, float optical_depth);

/// A sampled free path: how far light travels before it is scattered.
struct FreePath {
    bool scattered = false;
    float optical_depth = 0.0f; ///< up to the scattering, or the limit
    Rgb weight{1.0f};           ///< the factor of the throughput; for scattered light,
                                ///<   it includes the scattering coefficient
};

/// Samples the optical depth at which light is scattered next, or that it reaches `limit` first;
/// draws no number where the medium does not scatter.  carried: the throughput, whose channels
/// weight the choice, not negative; the sum of its channels never grows.  docs/media.md (4).
FreePath sample_free_path(const Medium& medium, float limit, const Rgb& carried,
                          RandomSequence& random);

} // namespace hipmap
