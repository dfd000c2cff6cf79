#pragma once

#include "render/integrator/gather_record.h"
#include "render/maps/estimate.h"
#include "render/paths/direction_guide.h"

#include <cstdint>
#include <vector>

namespace hipmap {

/// The directions from which light comes, by place on each side of the shared maps: what
/// final-gather rays find, docs/light_transport.md (43), or the sky (49).
struct PlacedGuides : Placed<DirectionGuide> {};

/// Returns the directions at a place.  Null: the lobes alone are as good.  Thread-safe.
const DirectionGuide* directions_at(const PlacedGuides& guide, const Partition& partition,
                                    const PhotonQuery& query);

/// When directions are worth learning.
struct LearningRule {
    std::size_t fewest_rays = 512; ///< of a leaf of the tree; one with twice as many is split
    double least_gain = 1.2;       ///< by which the mean square of what rays find must fall
};

/// Learns from rays that the lobes drew.  Records move within their vector.  In parallel; the
/// result is the same at any thread count.  No record: no guide.
PlacedGuides learn_directions(const Partition& partition, std::vector<GatherRecord>& records,
                              const LearningRule& rule = {});

/// Returns a checksum of the guide, by which states know it.
std::uint64_t checksum(const PlacedGuides& guide);

} // namespace hipmap
