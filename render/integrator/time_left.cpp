#include "render/integrator/time_left.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hipmap {

namespace {

/// As few passes as even out what one of them happens to take.
constexpr std::size_t kPassesOfLate = 4;

/// The share of a pass that is left at least while it takes longer than the passes before.
constexpr double kLeastLeft = 0.1;

/// Seconds until the pass under way is done.
double left_of_pass(const PassTimes& times, double now, double part)
{
    if (part >= 1)
        return 0;
    const double usual = times.lately();
    return std::max(usual - (now - times.begun), kLeastLeft * usual * (1 - part));
}

} // namespace

double PassTimes::lately() const
{
    const std::size_t number = std::min(whole.size(), kPassesOfLate);
    return std::accumulate(whole.end() - static_cast<std::ptrdiff_t>(number), whole.end(), 0.0) /
           static_cast<double>(number);
}

double PassTimes::slowest() const
{
    return whole.empty() ? 0 : *std::max_element(whole.begin(), whole.end());
}

std::optional<double> seconds_left(const PassTimes& times, double now, double part, double passes)
{
    part = std::clamp(part, 0.0, 1.0);
    if (!times.whole.empty())
        return left_of_pass(times, now, part) + std::max(passes - 1, 0.0) * times.lately();
    if (part > 0)
        return (now - times.begun) * std::max(passes - part, 0.0) / part;
    return std::nullopt;
}

double seconds_to_limit(const PassTimes& times, double now, double limit)
{
    if (times.whole.empty())
        return std::max(limit - now, 0.0);
    // The pass under way ends on its own; after it, those that fit.
    const double next = std::max(times.begun + times.lately(), now);
    const double fit =
        std::max(std::floor((limit - next - times.slowest()) / times.lately() + 1), 0.0);
    return next + fit * times.lately() - now;
}

} // namespace hipmap
