#include "render/many/pass_queue.h"

#include <algorithm>

namespace hipmap {

namespace {

/// A round lasts for this many passes of a rank, so that waiting for the slowest rank at its end
/// costs little, or for a share of the time so far within limits, if that is longer.
constexpr double kPassesOfRound = 30;
constexpr double kShareOfRound = 0.5;
constexpr double kShortestRound = 0.5, kLongestRound = 60; // s

} // namespace

PassQueue::PassQueue(const StopRules& rules, const std::atomic<bool>* stop, int ranks)
    : rules_(rules), stop_(stop), begun_(static_cast<std::size_t>(ranks))
{
}

void PassQueue::begin_round(const PassSet& held)
{
    const std::lock_guard lock(mutex_);
    taken_ = held;
    const std::uint64_t passes = count(held);
    left_ = rules_.passes - passes;
    if (rules_.error > 0)
        left_ = std::min(left_, next_check(passes) - passes);
    round_begun_ = watch_.seconds();
}

std::optional<std::uint64_t> PassQueue::next(int rank, bool stopped)
{
    const std::lock_guard lock(mutex_);
    const double now = watch_.seconds();
    std::optional<double>& begun = begun_[static_cast<std::size_t>(rank)];
    if (begun) {
        slowest_ = std::max(slowest_, now - *begun);
        ++rendered_;
    }
    begun.reset();
    stopped_ = stopped_ || stopped;
    if (left_ == 0 || is_stopped() || would_be_late() || now - round_begun_ > longest_round())
        return std::nullopt;
    --left_;
    begun = now;
    const std::uint64_t pass = next_missing(taken_, rules_.first_pass);
    taken_ = united(taken_, {{{pass, pass + 1}}});
    return pass;
}

std::optional<StopReason> PassQueue::reason_to_stop(const PassSet& held) const
{
    const std::lock_guard lock(mutex_);
    if (is_stopped())
        return StopReason::caller;
    if (count(held) >= rules_.passes)
        return StopReason::passes;
    if (would_be_late())
        return StopReason::time;
    return std::nullopt;
}

std::uint64_t PassQueue::rendered() const
{
    const std::lock_guard lock(mutex_);
    return rendered_;
}

/// No pass is begun that would not be over in time, but for the first of each rank.
bool PassQueue::would_be_late() const
{
    return rendered_ > 0 && watch_.seconds() + slowest_ > rules_.seconds;
}

double PassQueue::longest_round() const
{
    const double share = std::clamp(kShareOfRound * round_begun_, kShortestRound, kLongestRound);
    return std::max(share, kPassesOfRound * slowest_);
}

} // namespace hipmap
