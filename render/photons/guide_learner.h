#pragma once

#include "render/photons/trace_photons.h"

#include <span>
#include <vector>

namespace hipmap {

/// The start of a light path that was found from the eye.
struct EmissionSeed {
    std::size_t light = 0; ///< place in LightSet::lights
    PrimarySample at{};
    double weight = 0; ///< what all light that it stands for is worth
};

/// Learns the guide of one kind of light path (those not aimed, or the aimed ones) in rounds.  The
/// paths of a round are drawn from the guide learnt in all earlier rounds.  docs/light_transport.md
/// (41).
class GuideLearner {
  public:
    /// by_power: even_guide.  seeds: from which the guide of the first round is made; none: it is
    /// by power.
    GuideLearner(EmissionGuide by_power, RandomStream stream,
                 std::span<const EmissionSeed> seeds = {});

    /// Returns the guide for the next round.
    const EmissionGuide& guide() const { return guides_.back(); }

    /// Takes the paths of a round by guide(), and learns the next guide from all rounds.  plan: of
    /// the paths; worth: of each; options: by which they were traced.  No path: nothing.  In
    /// parallel; the same at any thread count.
    void add(const EmissionPlan& plan, std::span<const double> worth, const PhotonOptions& options);

    /// Returns whether guide() is clearly better than emission by power.
    bool is_worth_it() const;

    /// Returns whether a further round promises little.
    bool settled() const;

    /// Returns the best of all guides, with its variance; that by power, of variance 1, unless
    /// another is clearly better.
    EmissionGuide best() const;

    /// Returns the mean square of what one path by a guide is worth, from all paths so far.
    double mean_square(const EmissionGuide& guide) const;

  private:
    struct Point {
        std::size_t light = 0;
        PrimaryWorth worth;
    };

    double variance(const EmissionGuide& guide) const;
    double drawn_density(std::size_t round, const Point& point) const;
    void learn();

    RandomStream stream_;
    EmissionGuide by_power_;
    std::vector<EmissionGuide> guides_; ///< of the rounds, and of the next
    std::vector<EmissionPlan> plans_;   ///< of the rounds
    std::vector<Point> points_;         ///< starts of all paths that are worth something
};

} // namespace hipmap
