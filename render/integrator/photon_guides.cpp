#include "render/integrator/photon_guides.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

namespace hipmap {

namespace {

constexpr int kRounds = 6;

/// The part of the paths of a pass in the first round, which is the only one where a guide promises
/// little, and in each of the others.
constexpr std::uint64_t kFirstPart = 8, kPart = 2;
constexpr std::uint64_t kFewestPaths = 1 << 14, kFewestAimed = 1 << 12;
/// More teach a guide little, and the paths of all rounds are kept.
constexpr std::uint64_t kMostPaths = 1 << 17;

/// Returns the options of the photons of a round.  beyond_passes: it may have more paths than a
/// pass.
PhotonOptions round_options(PhotonOptions photons, int round, bool beyond_passes)
{
    const std::uint64_t part = round == 0 ? kFirstPart : kPart;
    const auto of_round = [part, beyond_passes](std::uint64_t paths, std::uint64_t fewest) {
        const std::uint64_t wanted = std::min(std::max(paths / part, fewest), kMostPaths);
        return beyond_passes && paths > 0 ? wanted : std::min(wanted, paths);
    };
    photons.paths = of_round(photons.paths, kFewestPaths);
    photons.caustic_paths = of_round(photons.caustic_paths, kFewestAimed);
    photons.pass -= static_cast<std::uint64_t>(round);
    photons.count_paths = true;
    photons.keep_arrivals = true;
    return photons;
}

/// The worth of each light path of a round, and the noise that it brings.
struct RoundWorth {
    std::vector<double> without_aim, noise_without_aim;
    std::vector<double> aimed, noise_aimed;
    std::vector<SplitRecord> arrivals;
};

RoundWorth worth_of_round(const MappedScene& mapped, const PhotonWorth& worth,
                          PhotonOptions photons, const PilotTeam& team)
{
    photons.part = team.rank;
    photons.parts = team.count;
    const TracedPhotons traced = trace_photons(mapped.scene, photons);
    WorthOfPaths own = worth_of_paths(mapped, worth, traced);
    const auto parted = [&](const std::vector<double>& all) {
        const auto first_aimed = all.begin() + static_cast<std::ptrdiff_t>(traced.emitted);
        return std::pair(joined(team, std::vector(all.begin(), first_aimed)),
                         joined(team, std::vector(first_aimed, all.end())));
    };
    auto [without_aim, aimed] = parted(own.paths);
    auto [noise_without_aim, noise_aimed] = parted(own.noise);
    return {std::move(without_aim), std::move(noise_without_aim), std::move(aimed),
            std::move(noise_aimed), joined(team, std::move(own.arrivals))};
}

/// Returns how many aimed paths there should be for each other one, so that the noise of both
/// together is least in the same time (Neyman 1934), docs/light_transport.md (41).  Arguments: the
/// noise that a path brings.
double aimed_share(double noise_without_aim, double noise_aimed)
{
    constexpr double kCost = 4; // of an aimed path over that of another
    constexpr double kLeast = 1.0 / 32, kMost = 0.5;
    return noise_without_aim > 0
               ? std::clamp(std::sqrt(noise_aimed / (kCost * noise_without_aim)), kLeast, kMost)
               : kMost;
}

double sum_of_squares(const std::vector<double>& values)
{
    return std::inner_product(values.begin(), values.end(), values.begin(), 0.0);
}

/// The noise that paths of one kind bring, and the square of what they are worth, over all rounds.
struct NoiseOfWorth {
    double noise = 0, square = 0;

    void add(const std::vector<double>& worth_of_paths, const std::vector<double>& noise_of_paths)
    {
        square += sum_of_squares(worth_of_paths);
        noise = std::reduce(noise_of_paths.begin(), noise_of_paths.end(), noise);
    }

    /// One path's noise over the square of its worth: the part that the guides do not change.
    double by_square() const { return square > 0 ? noise / square : 1; }
};

/// Importons do not see photons in media.
bool has_volume_photons(const RenderScene& scene)
{
    return scene.has_media() && (scene.media->scatters || scene.media->emits);
}

/// The least part by which splitting is to lower the mean square of what a path is worth.
constexpr double kWorthSplitting = 0.4;

/// Learns the guides of both kinds of light path, and where those without aim split.
class Learners {
  public:
    Learners(const RenderScene& scene, const EmissionGuide& by_power,
             std::span<const EmissionSeed> seeds)
        : scene_(scene), without_aim_(by_power, RandomStream::photons, seeds),
          aimed_(by_power, RandomStream::caustics)
    {
    }

    /// Returns whether paths without aim are worth a guide.
    bool is_worth_it() const { return without_aim_.is_worth_it(); }
    bool settled() const { return without_aim_.settled() && aimed_.settled(); }

    /// Returns the guides of the next round, without splitting.
    PhotonGuides guides() const { return {without_aim_.guide(), aimed_.guide()}; }

    /// Returns where paths that start by a guide split.
    PathSplitting splitting_by(const EmissionGuide& guide)
    {
        return learn_splitting(scene_.partition, arrivals_,
                               std::sqrt(without_aim_.mean_square(guide)));
    }

    void add(const PhotonGuides& by, const RoundWorth& found, const PhotonOptions& options)
    {
        if (!found.without_aim.empty())
            without_aim_.add(plan_emission(by.without_aim, options.paths), found.without_aim,
                             options);
        if (!found.aimed.empty())
            aimed_.add(plan_emission(by.aimed, options.caustic_paths), found.aimed, options);
        noise_without_aim_.add(found.without_aim, found.noise_without_aim);
        noise_aimed_.add(found.aimed, found.noise_aimed);
        saved_ = std::max(saved_, share_saved(by.splitting, found));
        arrivals_.insert(arrivals_.end(), found.arrivals.begin(), found.arrivals.end());
    }

    /// Returns the best of what was learnt.
    PhotonGuides best()
    {
        PhotonGuides out{without_aim_.best(), aimed_.best()};
        out.aimed_share =
            aimed_share(without_aim_.mean_square(out.without_aim) * noise_without_aim_.by_square(),
                        aimed_.mean_square(out.aimed) * noise_aimed_.by_square());
        if (saved_ > kWorthSplitting)
            out.splitting = splitting_by(out.without_aim);
        return out;
    }

  private:
    /// Returns by which part splitting lowered the mean square of what a path of a round is worth.
    double share_saved(const PathSplitting& splitting, const RoundWorth& found) const
    {
        const double saved = square_saved(splitting, scene_.partition, found.arrivals);
        const double squares = saved + sum_of_squares(found.without_aim);
        return squares > 0 ? saved / squares : 0;
    }

    const RenderScene& scene_;
    GuideLearner without_aim_, aimed_;
    NoiseOfWorth noise_without_aim_, noise_aimed_;
    std::vector<SplitRecord> arrivals_;
    double saved_ = 0; ///< by splitting, in the round where it was most
};

} // namespace

std::shared_ptr<const PhotonGuides>
learn_guides(const MappedScene& mapped, const PhotonOptions& photons, const PhotonWorth& worth,
             std::span<const EmissionSeed> seeds, const PilotControl& pilots)
{
    if (has_volume_photons(mapped.scene))
        return nullptr;
    Learners learners(mapped.scene, even_guide(mapped.scene.lights, Emitters::all_but_media),
                      seeds);
    for (int round = 0; round < kRounds && !stopped_together(pilots); ++round) {
        PhotonOptions pilot = round_options(photons, round, round > 0 || !seeds.empty());
        PhotonGuides guides = learners.guides();
        if (round > 0 && learners.is_worth_it())
            guides.splitting = learners.splitting_by(guides.without_aim);
        else if (round > 0)
            pilot.paths = 0; // a guide of the aimed ones alone is learnt
        pilot.guides = &guides;
        learners.add(guides, worth_of_round(mapped, worth, pilot, pilots.team), pilot);
        if (learners.settled())
            break;
    }
    PhotonGuides out = learners.best();
    const bool found = out.without_aim.variance < 1 || out.aimed.variance < 1;
    return found ? std::make_shared<const PhotonGuides>(std::move(out)) : nullptr;
}

std::uint64_t checksum(const PhotonGuides& guides)
{
    std::uint64_t sum = 0;
    const auto add = [&](double value) {
        sum = mix_bits(sum + std::bit_cast<std::uint64_t>(value) + 1);
    };
    add(guides.aimed_share);
    for (const EmissionGuide* guide : {&guides.without_aim, &guides.aimed})
        for (const EmissionGuide::OfLight& light : guide->lights) {
            add(light.share);
            for (const PrimaryDensity::Node& node : light.density.nodes)
                add(node.lower_share);
        }
    add(guides.splitting.usual);
    for (const float deviation : guides.splitting.deviation.values)
        add(double{deviation});
    return sum;
}

} // namespace hipmap
