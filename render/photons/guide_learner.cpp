#include "render/photons/guide_learner.h"

#include <tbb/parallel_for.h>

#include <numeric>
#include <utility>

namespace hipmap {

namespace {

/// The share of paths that start by power whatever is learnt, so that no power grows above 4 times.
constexpr double kByPower = 0.25;

/// The most of the variance of emission by power at which a guide is worth its pilots, and of the
/// present variance at which another round is.
constexpr double kWorthIt = 0.5;
constexpr double kGoOn = 0.8;

/// Points that are to matter after the first round; a quarter after each round more.
constexpr double kFirstAlike = 64;

/// The share of the first round's paths of a light that start by power, whatever its seeds are.
constexpr double kNotBySeeds = 0.5;

/// Returns the guide by power with starts near the seeds, where there are some.
EmissionGuide seeded(const EmissionGuide& by_power, std::span<const EmissionSeed> seeds)
{
    EmissionGuide out = by_power;
    std::vector<std::vector<PrimaryWorth>> of_light(out.lights.size());
    for (const EmissionSeed& seed : seeds)
        of_light[seed.light].push_back({.at = seed.at, .worth = 1, .density = 1 / seed.weight});
    tbb::parallel_for(std::size_t{0}, of_light.size(), [&](std::size_t light) {
        if (!of_light[light].empty())
            out.lights[light].density =
                mixed_with_even(learn_density(of_light[light], kFirstAlike), kNotBySeeds);
    });
    return out;
}

} // namespace

GuideLearner::GuideLearner(EmissionGuide by_power, RandomStream stream,
                           std::span<const EmissionSeed> seeds)
    : stream_(stream), by_power_(std::move(by_power)), guides_{seeded(by_power_, seeds)}
{
}

void GuideLearner::add(const EmissionPlan& plan, std::span<const double> worth,
                       const PhotonOptions& options)
{
    if (plan.paths == 0)
        return;
    const std::size_t known = points_.size();
    std::vector<std::uint64_t> paths; // that are worth something
    for (std::uint64_t i = 0; i < plan.paths; ++i)
        if (worth[i] > 0)
            paths.push_back(i);
    points_.resize(known + paths.size());
    plans_.push_back(plan);
    tbb::parallel_for(std::size_t{0}, points_.size(), [&](std::size_t i) {
        const bool is_new = i >= known;
        if (is_new) {
            const std::uint64_t path = paths[i - known];
            const LightShare share = share_of(plan, path);
            RandomSequence random = path_sequence(options, stream_, share);
            const DrawnPrimary start = draw_start(guide(), share.light, random);
            // Without the density and the number of paths, by which the power was divided.
            const double whole =
                worth[path] * start.density * static_cast<double>(share.path.paths);
            points_[i] = {share.light, {start.at, whole, 0}};
        }
        for (std::size_t round = is_new ? 0 : plans_.size() - 1; round < plans_.size(); ++round)
            points_[i].worth.density += drawn_density(round, points_[i]);
    });
    learn();
}

/// The density by which a round draws a start, times the paths of its light.
double GuideLearner::drawn_density(std::size_t round, const Point& point) const
{
    const EmissionPlan& plan = plans_[round];
    const auto paths =
        static_cast<double>(plan.first_path[point.light + 1] - plan.first_path[point.light]);
    return paths * density_at(guides_[round].lights[point.light].density, point.worth.at);
}

void GuideLearner::learn()
{
    std::vector<std::vector<PrimaryWorth>> of_light(by_power_.lights.size());
    for (const Point& point : points_)
        of_light[point.light].push_back(point.worth);
    std::vector<LearntDensity> learnt(of_light.size());
    const double alike = kFirstAlike / static_cast<double>(1 << (2 * (plans_.size() - 1)));
    tbb::parallel_for(std::size_t{0}, of_light.size(), [&](std::size_t light) {
        learnt[light] = learn_density(of_light[light], alike);
    });
    double total = 0;
    for (const LearntDensity& light : learnt)
        total += light.worth;
    EmissionGuide next = by_power_;
    for (std::size_t i = 0; i < learnt.size() && total > 0; ++i) {
        const double by_power = kByPower * by_power_.lights[i].share;
        next.lights[i].share = by_power + (1 - kByPower) * learnt[i].worth / total;
        if (learnt[i].worth > 0)
            next.lights[i].density = mixed_with_even(learnt[i], by_power / next.lights[i].share);
    }
    guides_.push_back(std::move(next));
}

double GuideLearner::mean_square(const EmissionGuide& guide) const
{
    std::vector<double> squares(points_.size());
    tbb::parallel_for(std::size_t{0}, points_.size(), [&](std::size_t i) {
        const EmissionGuide::OfLight& light = guide.lights[points_[i].light];
        const PrimaryWorth& at = points_[i].worth;
        squares[i] =
            at.worth * at.worth / (at.density * light.share * density_at(light.density, at.at));
    });
    // In the order of the points: the same at any thread count.
    return std::accumulate(squares.begin(), squares.end(), 0.0);
}

/// The variance of the photons' worth by a guide over that by power.
double GuideLearner::variance(const EmissionGuide& guide) const
{
    const double by_power = mean_square(by_power_);
    return by_power > 0 ? mean_square(guide) / by_power : 1;
}

bool GuideLearner::is_worth_it() const
{
    return variance(guide()) <= kWorthIt;
}

bool GuideLearner::settled() const
{
    return guides_.size() < 2 || !is_worth_it() ||
           variance(guide()) > kGoOn * variance(guides_[guides_.size() - 2]);
}

EmissionGuide GuideLearner::best() const
{
    const EmissionGuide* best = &by_power_;
    double least = kWorthIt;
    for (const EmissionGuide& guide : guides_)
        if (const double found = variance(guide); found < least) {
            least = found;
            best = &guide;
        }
    EmissionGuide out = *best;
    out.variance = best == &by_power_ ? 1 : least;
    return out;
}

} // namespace hipmap
