#include "render/maps/curve_order.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace hipmap {

namespace {

constexpr std::uint32_t kAxisBits = 10;
constexpr std::uint32_t kCells = 1u << kAxisBits; ///< along an axis, and of a digit of the sort
constexpr int kDigits = 3;

/// Every third bit.
std::uint32_t spread_bits(std::uint32_t x)
{
    x = (x | x << 16) & 0x30000ff;
    x = (x | x << 8) & 0x300f00f;
    x = (x | x << 4) & 0x30c30c3;
    return (x | x << 2) & 0x9249249;
}

/// NaN is cell 0.
std::uint32_t cell(float coordinate)
{
    return coordinate > 0
               ? static_cast<std::uint32_t>(std::min(coordinate, static_cast<float>(kCells - 1)))
               : 0;
}

std::uint32_t digit(std::uint64_t key, int d)
{
    return static_cast<std::uint32_t>(key >> (32 + kAxisBits * static_cast<std::uint32_t>(d))) %
           kCells;
}

} // namespace

void order_along_curve(const CurveBox& box, std::span<const glm::vec3> points,
                       std::vector<std::uint64_t>& order, std::vector<std::uint64_t>& other)
{
    const glm::vec3 extent = box.high - box.low;
    const float side = std::max({extent.x, extent.y, extent.z, std::numeric_limits<float>::min()});
    const float scale = static_cast<float>(kCells) / side;
    order.resize(points.size());
    other.resize(points.size());
    std::array<std::array<std::uint32_t, kCells>, kDigits> next{};
    for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::vec3 at = scale * (points[i] - box.low);
        const std::uint64_t place =
            spread_bits(cell(at.x)) << 2 | spread_bits(cell(at.y)) << 1 | spread_bits(cell(at.z));
        order[i] = place << 32 | i;
        for (int d = 0; d < kDigits; ++d)
            ++next[static_cast<std::size_t>(d)][digit(order[i], d)];
    }
    for (int d = 0; d < kDigits; ++d) {
        auto& places = next[static_cast<std::size_t>(d)];
        std::uint32_t sum = 0;
        for (std::uint32_t& place : places)
            sum += std::exchange(place, sum);
        for (const std::uint64_t key : order)
            other[places[digit(key, d)]++] = key;
        order.swap(other);
    }
}

} // namespace hipmap
