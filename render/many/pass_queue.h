#pragma once

#include "common/stopwatch.h"
#include "render/integrator/run_passes.h"

#include <mutex>
#include <vector>

namespace hipmap {

/// Hands out the numbers of passes to ranks, in order, round by round.  A round ends where the
/// error is to be looked at or the passes are all handed out, and after some time, so that the
/// ranks add up what they have.  Thread-safe.
class PassQueue {
  public:
    /// rules, stop: borrowed.
    PassQueue(const StopRules& rules, const std::atomic<bool>* stop, int ranks);

    /// Begins a round.  held: the passes that the film holds.
    void begin_round(const PassSet& held);
    /// Returns the next pass for a rank, which has rendered its last one; nothing: the round is
    /// over for it.  stopped: the rank was told to stop, so all are.
    std::optional<std::uint64_t> next(int rank, bool stopped);

    /// Returns why no further round is to begin, but for an error that is met; none: go on.
    /// held: the passes that the film holds.
    std::optional<StopReason> reason_to_stop(const PassSet& held) const;
    /// Returns the number of passes that ranks have rendered, of all rounds.
    std::uint64_t rendered() const;
    /// Returns the seconds since the queue was made.
    double seconds() const { return watch_.seconds(); }

  private:
    bool is_stopped() const { return stopped_ || (stop_ != nullptr && stop_->load()); }
    bool would_be_late() const;
    double longest_round() const;

    const StopRules& rules_;
    const std::atomic<bool>* const stop_;
    const Stopwatch watch_;
    mutable std::mutex mutex_;
    std::vector<std::optional<double>> begun_; ///< [ranks] s, of the pass that a rank renders
    PassSet taken_;
    std::uint64_t left_ = 0;     ///< passes of the round
    std::uint64_t rendered_ = 0; ///< passes of all rounds
    double slowest_ = 0;         ///< s, of a pass
    double round_begun_ = 0;
    bool stopped_ = false;
};

} // namespace hipmap
