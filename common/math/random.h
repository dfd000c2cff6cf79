#pragma once

#include "common/math/scrambled_sobol.h"

#include <glm/vec2.hpp>

#include <array>
#include <cstdint>

namespace hipmap {

/// The output function of SplitMix64 (Steele, Lea and Flood 2014): a bijection that mixes all bits.
inline std::uint64_t mix_bits(std::uint64_t x)
{
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
    return x ^ (x >> 31);
}

/// Purposes that random numbers are drawn for.  Streams of one seed are independent.
enum class RandomStream : std::uint64_t {
    photons = 1,
    eye_paths = 2,
    pictures = 3,
    caustics = 4,
    seen_lights = 5,
    seeds = 6,
    reached_lights = 7,
    sky = 8,
    emissive_faces = 9
};

/// The first steps of a sequence, where each call of next() or next2() is one: a point of the unit
/// cube of primary samples (Kelemen et al. 2002).  A step by next() leaves its y out.
inline constexpr std::size_t kPrimarySteps = 4;
using PrimarySample = std::array<glm::vec2, kPrimarySteps>;

/// Uniform numbers in [0, 1) as a function of (seed, stream, pass, path, dimension) alone, so that
/// neither the number of threads nor the order of work can change them.
///
/// A sample index can be given for samples that are summed: samples 0, 1, 2, ... of a path are then
/// stratified in each dimension and each pair of dimensions (`scrambled_sobol`), while every sample
/// stays uniform.
class RandomSequence {
  public:
    RandomSequence(std::uint64_t seed, RandomStream stream, std::uint64_t pass, std::uint64_t path)
        : state_(key_of(seed, stream, pass, path))
    {
    }

    RandomSequence(std::uint64_t seed, RandomStream stream, std::uint64_t pass, std::uint64_t path,
                   std::uint64_t index)
        // Beyond 2^32 points the sequence begins anew.
        : state_(key_of(seed, stream, pass, path) ^ mix_bits(index >> 32)),
          reversed_index_(reverse_bits(static_cast<std::uint32_t>(index))), stratified_(true)
    {
    }

    /// Returns the next dimension, with 24 random bits.
    float next()
    {
        if (given_ != nullptr)
            return next_given().x;
        state_ += kStep;
        const std::uint64_t mixed = mix_bits(state_);
        return stratified_
                   ? fraction(first_scrambled(shuffled_index(reversed_index_, mixed), mixed))
                   : fraction(static_cast<std::uint32_t>(mixed >> 32));
    }

    /// Returns the next two dimensions.
    glm::vec2 next2()
    {
        if (given_ != nullptr)
            return next_given();
        if (!stratified_) {
            const float u = next();
            return {u, next()};
        }
        state_ += kStep;
        const FractionPair pair = scrambled_sobol(reversed_index_, mix_bits(state_));
        return {fraction(pair.x), fraction(pair.y)};
    }

    /// Makes the next steps those of `sample`, which must outlive them; the sequence goes on after
    /// them.
    void give(const PrimarySample& sample)
    {
        given_ = sample.data();
        end_of_given_ = given_ + sample.size();
    }

    /// Drops the given steps that are left.
    void take_back() { given_ = nullptr; }

  private:
    glm::vec2 next_given()
    {
        const glm::vec2 step = *given_++;
        if (given_ == end_of_given_)
            given_ = nullptr;
        return step;
    }

    static constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15ull;

    static float fraction(std::uint32_t bits) { return static_cast<float>(bits >> 8) * 0x1p-24f; }

    static std::uint64_t key_of(std::uint64_t seed, RandomStream stream, std::uint64_t pass,
                                std::uint64_t path)
    {
        std::uint64_t key = mix_bits(seed + kStep);
        key = mix_bits(key ^ (static_cast<std::uint64_t>(stream) + kStep));
        key = mix_bits(key ^ (pass + kStep));
        return mix_bits(key ^ (path + kStep));
    }

    std::uint64_t state_;
    const glm::vec2* given_ = nullptr;
    const glm::vec2* end_of_given_ = nullptr;
    std::uint32_t reversed_index_ = 0;
    bool stratified_ = false;
};

} // namespace hipmap
