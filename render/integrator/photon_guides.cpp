#include "render/integrator/photon_guides.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

namespace hipmap {

namespace {

constexpr int kRounds = 6;

/// The part of the paths of a pass in the first round, which is the only one where a guide promises
/// little, and in each of the others.
constexpr std::uint64_t kFirstPart = 8, kPart = 2;
constexpr std::uint64_t kFewestPaths = 1 << 14, kFewestAimed = 1 << 12;
/// More teach a guide little, and the paths of all rounds are kept.
constexpr std::uint64_t kMostPaths = 1 << 17;

std::uint64_t paths_of_round(std::uint64_t paths, std::uint64_t part, std::uint64_t fewest)
{
    return std::min({paths, std::max(paths / part, fewest), kMostPaths});
}

/// Returns the options of the photons of a round.
PhotonOptions round_options(PhotonOptions photons, int round)
{
    const std::uint64_t part = round == 0 ? kFirstPart : kPart;
    photons.paths = paths_of_round(photons.paths, part, kFewestPaths);
    photons.caustic_paths = paths_of_round(photons.caustic_paths, part, kFewestAimed);
    photons.pass -= static_cast<std::uint64_t>(round);
    photons.count_paths = true;
    return photons;
}

/// The worth of each light path of a round.
struct RoundWorth {
    std::vector<double> without_aim, aimed;
};

RoundWorth worth_of_round(const MappedScene& mapped, const PhotonWorth& worth,
                          PhotonOptions photons, const PilotTeam& team)
{
    photons.part = team.rank;
    photons.parts = team.count;
    const TracedPhotons traced = trace_photons(mapped.scene, photons);
    const std::vector<double> own = worth_of_paths(mapped, worth, traced);
    const auto first_aimed = own.begin() + static_cast<std::ptrdiff_t>(traced.emitted);
    return {joined(team, std::vector(own.begin(), first_aimed)),
            joined(team, std::vector(first_aimed, own.end()))};
}

/// Returns how many aimed paths there should be for each other one, so that the noise of both
/// together is least in the same time (Neyman 1934), docs/light_transport.md (41).  Arguments: mean
/// squares of what a path is worth.
double aimed_share(double square_without_aim, double square_aimed)
{
    constexpr double kCost = 4; // of an aimed path over that of another
    constexpr double kLeast = 1.0 / 32, kMost = 1;
    return square_without_aim > 0
               ? std::clamp(std::sqrt(square_aimed / (kCost * square_without_aim)), kLeast, kMost)
               : kMost;
}

/// Importons do not see photons in media.
bool has_volume_photons(const RenderScene& scene)
{
    return scene.has_media() && (scene.media->scatters || scene.media->emits);
}

} // namespace

std::shared_ptr<const PhotonGuides>
learn_guides(const MappedScene& mapped, const PhotonOptions& photons, const PhotonWorth& worth,
             std::span<const EmissionSeed> seeds, const PilotControl& pilots)
{
    if (has_volume_photons(mapped.scene))
        return nullptr;
    const EmissionGuide by_power = even_guide(mapped.scene.lights, Emitters::all_but_media);
    GuideLearner without_aim(by_power, RandomStream::photons, seeds);
    GuideLearner aimed(by_power, RandomStream::caustics);
    for (int round = 0; round < kRounds && !stopped_together(pilots); ++round) {
        PhotonOptions pilot = round_options(photons, round);
        if (round > 0 && !without_aim.is_worth_it())
            pilot.paths = 0; // a guide of the aimed ones alone is learnt
        const PhotonGuides guides{without_aim.guide(), aimed.guide()};
        pilot.guides = &guides;
        const RoundWorth found = worth_of_round(mapped, worth, pilot, pilots.team);
        if (!found.without_aim.empty())
            without_aim.add(plan_emission(guides.without_aim, pilot.paths), found.without_aim,
                            pilot);
        if (!found.aimed.empty())
            aimed.add(plan_emission(guides.aimed, pilot.caustic_paths), found.aimed, pilot);
        if (without_aim.settled() && aimed.settled())
            break;
    }
    PhotonGuides out{without_aim.best(), aimed.best()};
    const bool found = out.without_aim.variance < 1 || out.aimed.variance < 1;
    out.aimed_share =
        aimed_share(without_aim.mean_square(out.without_aim), aimed.mean_square(out.aimed));
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
    return sum;
}

} // namespace hipmap
