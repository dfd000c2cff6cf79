#pragma once

#include <optional>
#include <vector>

namespace hipmap {

/// The times of the passes of a run, s.
struct PassTimes {
    std::vector<double> whole; ///< of each pass that is done, in order
    double begun = 0;          ///< when the pass under way began, since the run began

    /// Returns the time that a pass takes lately; needs a pass that is done.
    double lately() const;
    /// Returns the longest time of a pass; 0: none is done.
    double slowest() const;
};

/// Predicts the seconds until a run has done `passes` more passes, the one under way included.
/// now: s since the run began.  part: of the pass under way that is done, 0 to 1.  Returns none
/// while nothing is done.  Passes take about the same time each, but the parts of a pass do not,
/// so `part` counts in the first pass alone.
std::optional<double> seconds_left(const PassTimes& times, double now, double part, double passes);

/// Predicts the seconds until a run ends that begins no pass which would not be over within
/// `limit` s.
double seconds_to_limit(const PassTimes& times, double now, double limit);

} // namespace hipmap
