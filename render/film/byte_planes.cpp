#include "render/film/byte_planes.h"

#include <cassert>

namespace hipmap {

namespace {

/// Values between a sum and that of the same channel in the pixel before.
constexpr std::size_t kChannels = 3;

constexpr std::size_t kBytes = sizeof(std::int64_t);

/// Maps small numbers of both signs to small numbers: 0, -1, 1, -2 to 0, 1, 2, 3.
std::uint64_t fold_sign(std::uint64_t number)
{
    return (number << 1) ^ (0 - (number >> 63));
}

std::uint64_t unfold_sign(std::uint64_t folded)
{
    return (folded >> 1) ^ (0 - (folded & 1));
}

} // namespace

std::vector<std::byte> split_into_planes(std::span<const std::int64_t> sums)
{
    std::vector<std::byte> planes(kBytes * sums.size());
    for (std::size_t i = 0; i < sums.size(); ++i) {
        // Unsigned, as differences of any two sums wrap around and back.
        const std::uint64_t before =
            i < kChannels ? 0 : static_cast<std::uint64_t>(sums[i - kChannels]);
        const std::uint64_t folded = fold_sign(static_cast<std::uint64_t>(sums[i]) - before);
        for (std::size_t byte = 0; byte < kBytes; ++byte)
            planes[byte * sums.size() + i] = static_cast<std::byte>(folded >> (8 * byte));
    }
    return planes;
}

void join_planes(std::span<const std::byte> planes, std::span<std::int64_t> sums)
{
    assert(planes.size() == kBytes * sums.size());
    for (std::size_t i = 0; i < sums.size(); ++i) {
        std::uint64_t folded = 0;
        for (std::size_t byte = 0; byte < kBytes; ++byte)
            folded |= static_cast<std::uint64_t>(planes[byte * sums.size() + i]) << (8 * byte);
        const std::uint64_t before =
            i < kChannels ? 0 : static_cast<std::uint64_t>(sums[i - kChannels]);
        sums[i] = static_cast<std::int64_t>(unfold_sign(folded) + before);
    }
}

} // namespace hipmap
