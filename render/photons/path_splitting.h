#pragma once

#include "render/paths/placed.h"

namespace hipmap {

/// What became of a light path that arrived at a surface that gathers.
struct SplitRecord {
    Place at;
    float worth = 0; ///< of all that the path left from there on, by the power with which it came
    float power = 0; ///< sum of the channels
    int splits = 1;  ///< it is one of so many that split there
};

/// Where light paths split, docs/light_transport.md (52).
struct PathSplitting {
    /// Standard deviation of what a path of power 1 is worth from a place on.
    Placed<float> deviation;
    float most = 0;   ///< of the deviations
    double usual = 0; ///< root mean square of what a path is worth, times the number of paths
};

/// Learns it from records, which move within their vector.  usual: as PathSplitting has it; zero,
/// or no record: paths do not split.  In parallel; the same at any thread count.
PathSplitting learn_splitting(const Partition& partition, std::vector<SplitRecord>& records,
                              double usual);

/// Returns how much more the sum of the squares of what paths are worth would be in expectation,
/// had they not split by `splitting`.  records: of those paths.
double square_saved(const PathSplitting& splitting, const Partition& partition,
                    std::span<const SplitRecord> records);

/// The most paths that go on from the start of one.
inline constexpr int kMostSplits = 64;

/// Returns into how many paths one splits that arrives at a place, at least 1.  power: sum of the
/// channels, times the number of paths; of: how many go on from its start as it does.  Thread-safe.
int splits_at(const PathSplitting& splitting, const Partition& partition, const Place& at,
              double power, int of);

} // namespace hipmap
