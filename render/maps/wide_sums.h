#pragma once

#include "render/maps/photon_powers.h"
#include "render/maps/wide_search.h"

#include <array>

namespace hipmap {

/// The powers of the k photons nearest to a point, without a list of them.
struct NearestSum {
    PowerSum power{0};       ///< of all but the farthest if there are k of them, else of all
    std::size_t photons = 0; ///< found, at most k
    float farthest2 = 0.0f;  ///< square distance of the farthest
};

/// Sums the photons that find_nearest finds, all but the last if there are k.  Exact, the same bits
/// whatever the scratch remembers and on every processor.  Blocks that are wholly nearer than the
/// k-th photon can be are added without a look at their photons.  powers: of this tree. Thread-safe
/// with a scratch for each thread.
NearestSum sum_nearest(const WideTree& tree, const PhotonPowers& powers, const TreeQuery& query,
                       TreeScratch& scratch);

/// The powers of all photons within a radius.
struct RadiusSum {
    PowerSum power{0};
    std::uint64_t photons = 0;
};

/// Sums the photons within each of the radii, in one search.  Nodes and blocks wholly within a
/// radius are added by their sums.  radii2: squares, descending, >= 0, finite.  A point with a NaN
/// finds nothing.  Exact, and thread-safe with a scratch for each thread.
template <std::size_t n>
using RadiusSums = std::array<RadiusSum, n>;
RadiusSums<1> sum_within(const WideTree& tree, const PhotonPowers& powers, const glm::vec3& point,
                         const std::array<float, 1>& radii2, TreeScratch& scratch);
RadiusSums<3> sum_within(const WideTree& tree, const PhotonPowers& powers, const glm::vec3& point,
                         const std::array<float, 3>& radii2, TreeScratch& scratch);

} // namespace hipmap
