#pragma once

#include <glm/vec2.hpp>

#include <cstdint>

namespace hipmap {

/// The output function of SplitMix64 (Steele, Lea and Flood 2014): a bijection that mixes all bits.
inline std::uint64_t mix_bits(std::uint64_t x)
{
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
    return x ^ (x >> 31);
}

/// What random numbers are drawn for; streams of one seed are independent.
enum class RandomStream : std::uint64_t { photons = 1, eye_paths = 2, pictures = 3, caustics = 4 };

/// Uniform numbers in [0, 1) as a function of (seed, stream, pass, path, dimension) alone, so that
/// neither the number of threads nor the order of work can change them.
class RandomSequence {
  public:
    RandomSequence(std::uint64_t seed, RandomStream stream, std::uint64_t pass, std::uint64_t path)
    {
        std::uint64_t key = mix_bits(seed + kStep);
        key = mix_bits(key ^ (static_cast<std::uint64_t>(stream) + kStep));
        key = mix_bits(key ^ (pass + kStep));
        state_ = mix_bits(key ^ (path + kStep));
    }

    /// The next dimension; 24 bits.
    float next()
    {
        state_ += kStep;
        return static_cast<float>(mix_bits(state_) >> 40) * 0x1p-24f;
    }

    glm::vec2 next2()
    {
        const float u = next();
        return {u, next()};
    }

  private:
    static constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15ull;
    std::uint64_t state_;
};

} // namespace hipmap
