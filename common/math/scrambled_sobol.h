#pragma once

#include <cstdint>

namespace hipmap {

/// Reverses the order of the bits: bit 0 becomes bit 31 and so on.
inline std::uint32_t reverse_bits(std::uint32_t x)
{
    x = (x >> 1 & 0x55555555u) | (x & 0x55555555u) << 1;
    x = (x >> 2 & 0x33333333u) | (x & 0x33333333u) << 2;
    x = (x >> 4 & 0x0f0f0f0fu) | (x & 0x0f0f0f0fu) << 4;
    return __builtin_bswap32(x);
}

/// Applies Owen's scrambling (Owen 1995) to a number in [0, 1) whose bits are written in reverse,
/// by the hash of Laine and Karras (2011) in Vegdahl's form: whether a bit is flipped depends on
/// the seed and the more significant bits.  The result is in reverse too.
inline std::uint32_t scramble_reversed(std::uint32_t x, std::uint32_t seed)
{
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= seed >> 16 | 1u;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return x;
}

/// Returns the second dimension of Sobol's sequence with its bits in reverse.  Its matrix is
/// Pascal's triangle modulo 2, which has a one where the bits of the row are among those of the
/// column (Lucas), so five steps replace one step per bit.
inline std::uint32_t second_sobol_reversed(std::uint32_t index)
{
    std::uint32_t x = index;
    x ^= x >> 1 & 0x55555555u;
    x ^= x >> 2 & 0x33333333u;
    x ^= x >> 4 & 0x0f0f0f0fu;
    x ^= x >> 8 & 0x00ff00ffu;
    x ^= x >> 16;
    return x;
}

/// A point of the unit square, as 32-bit fractions.
struct FractionPair {
    std::uint32_t x, y;
};

/// Returns the number that a key's shuffle gives a point of a sequence.  Both numbers are less than
/// 2^32; the given one has its bits in reverse.
inline std::uint32_t shuffled_index(std::uint32_t reversed_index, std::uint64_t key)
{
    const auto seed = static_cast<std::uint32_t>(key);
    return reverse_bits(scramble_reversed(reversed_index, seed ^ 0x68bc21ebu));
}

/// The first dimension of `scrambled_sobol` alone: `shuffled` by `shuffled_index` of the key.
inline std::uint32_t first_scrambled(std::uint32_t shuffled, std::uint64_t key)
{
    return reverse_bits(scramble_reversed(shuffled, static_cast<std::uint32_t>(key >> 32)));
}

/// A point of a (0, 2)-sequence that is shuffled and scrambled by `key` (Burley 2020): any aligned
/// 2^m of the points have one in each of 2^m boxes of every shape, each point is uniform, and
/// points of different keys are independent.  reversed_index: `reverse_bits` of the point's number.
/// Cost: some 10 ns.
inline FractionPair scrambled_sobol(std::uint32_t reversed_index, std::uint64_t key)
{
    const std::uint32_t shuffled = shuffled_index(reversed_index, key);
    return {first_scrambled(shuffled, key),
            reverse_bits(scramble_reversed(second_sobol_reversed(shuffled),
                                           static_cast<std::uint32_t>(key)))};
}

} // namespace hipmap
