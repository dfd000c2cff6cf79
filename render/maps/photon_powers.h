#pragma once

#include "render/maps/wide_tree.h"
#include "render/photons/photon.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace hipmap {

/// The powers of the photons of a block, red, green and blue, in units of a PowerScale; zero in
/// lanes without a photon.
struct alignas(32) PowerBlock {
    std::uint16_t power[3][kTreeWidth];
};

/// A sum of powers in units of a PowerScale; exact in any order.
using PowerSum = glm::vec<3, std::uint64_t>;

/// The unit of stored powers, W / metres_per_unit^2 by channel: a 65534th of the largest power of a
/// set of photons.
struct PowerScale {
    glm::dvec3 unit{0.0};
};

/// Returns the scale for these photons; zero without any.  Powers that are not finite do not count.
PowerScale power_scale(std::span<const Photon> photons);

/// Rounds a power to units of the scale, docs/photon_maps.md (9): up or down at random so that its
/// mean is the power itself.  Many photons of one pass have the very same power, and plain rounding
/// would be off for all of them alike.  number: of the photon, which alone decides. NaN and
/// negative values become zero.
std::array<std::uint16_t, 3> round_power(const Rgb& power, const PowerScale& scale,
                                         std::uint64_t number);

/// Returns the number by which the power of a photon at a position is rounded.  No other photon
/// affects it.
std::uint64_t rounding_number(const glm::vec3& position);

/// Powers of the photons of a tree.
struct PhotonPowers {
    std::vector<PowerBlock> blocks; ///< parallel to the tree's
    std::vector<PowerSum> nodes;    ///< of all photons below each node, parallel to the tree's

    PowerSum of(std::uint32_t slot) const
    {
        const PowerBlock& block = blocks[slot / kTreeWidth];
        const std::uint32_t lane = slot % kTreeWidth;
        return {block.power[0][lane], block.power[1][lane], block.power[2][lane]};
    }
    /// Returns the bytes of the arrays.
    std::size_t bytes() const
    {
        return blocks.size() * sizeof(PowerBlock) + nodes.size() * sizeof(PowerSum);
    }
};

/// Stores the powers of a tree's photons.  points: as build_wide_tree left them; they give the
/// photons' numbers.  In parallel.
PhotonPowers build_powers(const WideTree& tree, std::span<const TreePoint> points,
                          std::span<const Photon> photons, const PowerScale& scale);

} // namespace hipmap
