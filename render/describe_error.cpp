#include "render/describe_error.h"

#include "common/math/square.h"
#include "common/report.h"
#include "common/scene/scene_names.h"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace hipmap {

namespace {

/// The share of the light that is worth a second look when it was removed.
constexpr double kMuchLight = 0.05;

std::string describe_removed(const RemovedFireflies& removed)
{
    if (removed.pixels == 0)
        return "";
    return "fireflies: removed from " + counted(removed.pixels, "pixel") + ", with " +
           percent(removed.light) + " of the light" +
           (removed.light > kMuchLight ? "; --fireflies keep leaves them in" : "");
}

std::string describe_kept(const Fireflies& fireflies)
{
    return "fireflies: " + counted(fireflies.pixels, "pixel carries", "pixels carry") + " " +
           percent(fireflies.share) + " of the squared error, which is " +
           percent(fireflies.error_without) +
           " without them; render more passes, leave out --fireflies keep, or make small bright "
           "lights larger";
}

} // namespace

std::string percent(double share)
{
    const double value = 100 * share;
    std::ostringstream text;
    if (value >= 1)
        text << std::fixed << std::setprecision(value < 10 ? 1 : 0);
    else
        text << std::setprecision(2);
    text << value << " %";
    return text.str();
}

std::string describe_error(const ErrorCheck& check)
{
    const ImageError& error = check.error;
    std::string text = "accuracy: error " + percent(error.error);
    if (std::isfinite(error.high))
        text += " (95 % confidence: " + percent(error.low) + " to " + percent(error.high) + ")";
    if (error.bias == BiasKnowledge::unknown)
        text += " of noise alone; the bias of estimates from the k nearest photons is unknown";
    if (error.bias == BiasKnowledge::from_radii)
        text += "; noise " + percent(std::sqrt(error.noise2)) + ", bias " +
                percent(std::sqrt(std::max(error.bias2, 0.0)));
    if (error.clamp2 > 0)
        text += "; bias of --clamp " + percent(std::sqrt(error.clamp2));
    if (error.removed2 > 0)
        text += "; bias of removed fireflies " + percent(std::sqrt(error.removed2));
    if (error.missing2 > square_of(error.error))
        text += "; light that few samples find may be missing, up to " +
                percent(std::sqrt(error.missing2));
    return text;
}

std::string describe_fireflies(const ShownFireflies& fireflies)
{
    if (fireflies.removed)
        return describe_removed(*fireflies.removed);
    return fireflies.kept ? describe_kept(*fireflies.kept) : "";
}

std::string describe_unseen(const UnseenLight& unseen, const std::string& light)
{
    const double lacks = std::isfinite(unseen.most) ? unseen.most / (1 + unseen.most) : 1;
    return "the image may lack up to " + percent(lacks) +
           " of its light (95 % confidence), which the error does not include: " +
           (unseen.never ? "no light path" : "only one light path of some kind") + " of " + light +
           " reached what the image sees in " + counted(unseen.passes, "pass", "passes") +
           "; raise --photons, render more passes, or widen the openings that the light comes "
           "through";
}

std::string describe_unreachable(std::span<const std::string> lights)
{
    std::string names = lights.front();
    for (const std::string& light :
         lights.subspan(1).first(std::min<std::size_t>(lights.size() - 1, 2)))
        names += ", " + light;
    if (lights.size() > 3)
        names += " and " + std::to_string(lights.size() - 3) + " more";
    return "the image may lack the light of " + names +
           " off mirrors and through clear glass, and the error does not include it: no path from "
           "the eye meets a light without a size or a spread; use --integrator progressive, or "
           "give it one";
}

std::string describe_lost(const LostLight& lost)
{
    return "photons that were not finite or whose paths were cut, and samples that were not "
           "finite, may add " +
           percent(std::sqrt(lost.error2())) +
           " to the error; look for materials and lights with extreme values";
}

std::string describe_need(const ErrorCost& cost)
{
    const auto practical = [](double passes, double seconds) {
        return seconds <= kMostPracticalSeconds && passes <= static_cast<double>(kMostPasses);
    };
    if (!practical(cost.passes, cost.seconds))
        return "is not practical (more than a day)";
    const auto passes = static_cast<std::size_t>(cost.passes);
    if (!cost.is_range() || !practical(cost.most_passes, cost.most_seconds))
        return std::string(cost.is_range() ? "would take at least about " : "would take about ") +
               counted(passes, "pass", "passes") + ", " + brief_time(cost.seconds);
    return "would take about " + grouped(passes) + " to " +
           counted(static_cast<std::size_t>(cost.most_passes), "pass", "passes") + ", " +
           brief_time(cost.seconds) + " to " + brief_time(cost.most_seconds);
}

std::string describe_cost(const RenderState& state, double target, double before)
{
    const ErrorCheck& last = state.checks.back();
    const ErrorLaw law = error_law(state.checks, state.radius_decay, state.film.expected);
    const bool of_target = target > 0 && target / 2 < last.error.error;
    const ErrorCost half =
        error_cost(state.checks, law, (of_target ? target : last.error.error) / 2, {0, before});
    std::string text = "cost: " + percent(last.error.error) + " in " +
                       counted(last.passes, "pass", "passes") + ", " +
                       brief_time(before + last.seconds);
    if (!std::isfinite(half.passes) || last.error.error == 0)
        return text;
    return text + "; " + percent(half.error) + " " + describe_need(half);
}

std::vector<ErrorCost> error_costs(const RenderState& state, double target, double before)
{
    const std::vector<ErrorCheck>& checks = state.checks;
    std::vector<ErrorCost> costs;
    if (checks.empty() || !(checks.back().error.error > 0))
        return costs;
    std::vector<double> errors = {0.3,  0.2,  0.1,   0.05,
                                  0.02, 0.01, 0.005, checks.back().error.error / 2};
    if (target > 0)
        errors.insert(errors.end(), {target, target / 2});
    std::sort(errors.begin(), errors.end(), std::greater<>());
    errors.erase(std::unique(errors.begin(), errors.end()), errors.end());
    const ErrorLaw law = error_law(checks, state.radius_decay, state.film.expected);
    for (const double error : errors)
        costs.push_back(error_cost(checks, law, error, {state.photons_per_pass, before}));
    return costs;
}

std::uint64_t peak_memory()
{
    constexpr std::uint64_t kUnit = 1024; // Linux counts in KiB
    rusage usage = {};
    if (::getrusage(RUSAGE_SELF, &usage) != 0)
        return 0;
    return static_cast<std::uint64_t>(usage.ru_maxrss) * kUnit;
}

} // namespace hipmap
