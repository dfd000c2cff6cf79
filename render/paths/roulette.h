#pragma once

#include "common/math/random.h"
#include "common/math/rgb.h"

#include <algorithm>

namespace hipmap {

/// Up to so many surfaces and scatterings a path has a probability to be ended only where it
/// carries less than kFullWeight of what it began with, from there on by all that it has lost.
inline constexpr int kRouletteDepth = 6;
inline constexpr float kFullWeight = 0.1f;

/// From here on also paths that have lost nothing are ended, by one in 1000: between perfect
/// mirrors nothing else would end them.  Not before, and no more: light caught in glass or in a
/// white room leaves after hundreds of reflections, and where a is what each of them keeps, the
/// square of what the surviving paths stand for adds up only while the probability is above a^2.
inline constexpr int kEndlessDepth = 512;
inline constexpr float kEndlessProbability = 0.999f;

/// The probability that Russian roulette lets a path go on, docs/light_transport.md (14).  depth:
/// surfaces and scatterings behind it.  carried: the largest channel of its throughput over what it
/// began with, times the square of the index of refraction around it, as radiance scales with that.
inline float survival_probability(int depth, float carried)
{
    if (depth < kRouletteDepth)
        return std::min(1.0f, carried / kFullWeight);
    return std::min(depth < kEndlessDepth ? 1.0f : kEndlessProbability, carried);
}

/// False: Russian roulette has ended the path; else its throughput stands for those ended too.
/// Draws a number only where the probability is below one.
inline bool survives(float probability, RandomSequence& random, Rgb& throughput)
{
    if (probability >= 1)
        return true;
    if (!(random.next() < probability))
        return false;
    throughput /= probability;
    return true;
}

} // namespace hipmap
