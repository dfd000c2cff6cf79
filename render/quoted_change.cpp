#include "render/quoted_change.h"

#include "common/report.h"
#include "render/describe_error.h"

#include <cmath>

namespace hipmap {

namespace {

/// Standard deviations below which a difference is not seen.
constexpr double kSeen = 2;

std::string describe(const QuotedIntegrator& other, double error)
{
    std::string out = other.option + ": " + percent(error) + " error ";
    if (other.bias == BiasKnowledge::unknown)
        out += "of noise alone ";
    return out + describe_need(other.cost);
}

std::string describe_saving(const QuotedEffect& effect, double error)
{
    const bool less = effect.saved >= 0;
    std::string out = (less ? "saves " : "takes ") + percent(std::abs(effect.saved)) +
                      (less ? " of the time of a pass" : " more time for a pass");
    if (std::abs(effect.seconds_saved) <= kMostPracticalSeconds)
        out += ", " + brief_time(std::abs(effect.seconds_saved)) + " on the way to " +
               percent(error) + " error";
    return out;
}

std::string describe_added(const FilmDifference& added)
{
    const double least = kSeen * added.spread, square = std::max(added.square, 0.0);
    if (square > least)
        return "adds about " + percent(std::sqrt(square)) + " error";
    if (!std::isfinite(least))
        return "adds an unknown error";
    return "adds less than " + percent(std::sqrt(square + least)) + " error";
}

} // namespace

std::vector<std::string> describe(const Quote& quote)
{
    std::vector<std::string> out;
    for (const QuotedIntegrator& other : quote.integrators)
        out.push_back(describe(other, quote.error));
    for (const QuotedEffect& effect : quote.effects)
        out.push_back(effect.option + ": " + describe_saving(effect, quote.error) + ", and " +
                      describe_added(effect.added));
    std::string left;
    for (const std::string& option : quote.not_compared)
        left += (left.empty() ? "" : ", ") + option;
    if (!left.empty())
        out.push_back("not compared, for lack of time: " + left +
                      "; a smaller --error gives the comparison more time");
    return out;
}

} // namespace hipmap
