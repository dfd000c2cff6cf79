#include "render/maps/photon_powers.h"

#include "common/math/random.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace hipmap {

namespace {

/// One less than fits, so that rounding up and the rounding of a quotient have room.
constexpr double kLargest = 65534;

/// By so many photons the processor is told early which it will need: they lie anywhere.
constexpr std::size_t kAhead = 4 * kTreeWidth;

/// Three numbers in [0, 1).
glm::dvec3 random_thirds(std::uint64_t number)
{
    const std::uint64_t bits = mix_bits(mix_bits(number) + 0x9e3779b97f4a7c15ull);
    const auto part = [&](int shift) {
        return static_cast<double>(bits >> shift & 0x1fffff) * 0x1p-21;
    };
    return {part(0), part(21), part(42)};
}

PowerSum sum_block(const PowerBlock& block)
{
    PowerSum sum(0);
    for (int channel = 0; channel < 3; ++channel)
        for (const std::uint16_t power : block.power[channel])
            sum[channel] += power;
    return sum;
}

/// From the leaf nodes up.
std::vector<PowerSum> sum_nodes(const WideTree& tree, const std::vector<PowerBlock>& blocks)
{
    std::vector<PowerSum> sums(tree.nodes.size(), PowerSum(0));
    std::size_t children = blocks.size(), below = sums.size();
    for (std::uint32_t level = tree.levels; level-- > 0;) {
        const std::size_t first = tree.first_node[level];
        for (std::size_t child = 0; child < children; ++child)
            sums[first + child / kTreeWidth] +=
                below == sums.size() ? sum_block(blocks[child]) : sums[below + child];
        children = below - first;
        below = first;
    }
    return sums;
}

} // namespace

PowerScale power_scale(std::span<const Photon> photons)
{
    using Range = tbb::blocked_range<std::size_t>;
    const Rgb largest = tbb::parallel_reduce(
        Range(0, photons.size()), Rgb(0.0f),
        [&](const Range& range, Rgb most) {
            for (std::size_t i = range.begin(); i < range.end(); ++i)
                if (is_finite(photons[i].power))
                    most = glm::max(most, photons[i].power);
            return most;
        },
        [](const Rgb& a, const Rgb& b) { return glm::max(a, b); });
    return {glm::dvec3(largest) / kLargest};
}

std::array<std::uint16_t, 3> round_power(const Rgb& power, const PowerScale& scale,
                                         std::uint64_t number)
{
    const glm::dvec3 random = random_thirds(number);
    std::array<std::uint16_t, 3> out{};
    for (int channel = 0; channel < 3; ++channel) {
        const double units = double{power[channel]} / scale.unit[channel];
        if (units > 0 && units < kLargest + 1)
            out[channel] = static_cast<std::uint16_t>(units + random[channel]);
    }
    return out;
}

std::uint64_t rounding_number(const glm::vec3& position)
{
    const auto bits = [](float value) {
        return std::uint64_t{std::bit_cast<std::uint32_t>(value)};
    };
    return mix_bits(bits(position.x) << 32 | bits(position.y)) ^ bits(position.z);
}

PhotonPowers build_powers(const WideTree& tree, std::span<const TreePoint> points,
                          std::span<const Photon> photons, const PowerScale& scale)
{
    PhotonPowers powers;
    powers.blocks.resize(tree.blocks.size());
    tbb::parallel_for(std::size_t{0}, powers.blocks.size(), [&](std::size_t b) {
        const std::size_t begin = b * kTreeWidth;
        const std::size_t lanes = std::min<std::size_t>(kTreeWidth, points.size() - begin);
        const std::size_t ahead = std::min(points.size(), begin + kAhead);
        for (std::size_t i = ahead; i < std::min(points.size(), ahead + kTreeWidth); ++i)
            __builtin_prefetch(&photons[points[i].photon].power);
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            const TreePoint& point = points[begin + lane];
            const auto rounded =
                round_power(photons[point.photon].power, scale, rounding_number(point.position));
            for (int channel = 0; channel < 3; ++channel)
                powers.blocks[b].power[channel][lane] = rounded[channel];
        }
    });
    powers.nodes = sum_nodes(tree, powers.blocks);
    return powers;
}

} // namespace hipmap
