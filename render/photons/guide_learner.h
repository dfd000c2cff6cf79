#pragma once

#include "render/photons/trace_photons.h"

#include <span>
#include <vector>

namespace hipmap {

/// Learns the guide of one kind of light path (those not aimed, or the aimed ones) in rounds, each
/// of which traces paths by the guide learnt from the rounds before.  docs/light_transport.md (41).
class GuideLearner {
  public:
    /// by_power: the guide of the first round (even_guide).
    GuideLearner(EmissionGuide by_power, RandomStream stream);

    /// Returns the guide for the next round.
    const EmissionGuide& guide() const { return guides_.back(); }

    /// Takes the paths of a round by guide(), and learns the next guide from all rounds.  plan: of
    /// the paths; worth: of each; options: by which they were traced.  No path: nothing.
    void add(const EmissionPlan& plan, std::span<const double> worth, const PhotonOptions& options);

    /// Returns whether a further round promises little.
    bool settled() const;

    /// Returns the best of all guides, with its variance; that by power, of variance 1, unless
    /// another is clearly better.
    EmissionGuide best() const;

  private:
    struct Point {
        std::size_t light = 0;
        PrimaryWorth worth;
    };

    double variance(const EmissionGuide& guide) const;
    double drawn_density(std::size_t round, const Point& point) const;
    void learn();

    RandomStream stream_;
    std::vector<EmissionGuide> guides_; ///< of the rounds, and of the next
    std::vector<EmissionPlan> plans_;   ///< of the rounds
    std::vector<Point> points_;         ///< starts of all paths that are worth something
};

} // namespace hipmap
