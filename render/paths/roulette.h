#pragma once

#include "common/math/random.h"
#include "common/math/rgb.h"
#include "render/paths/path_class.h"

#include <algorithm>

namespace hipmap {

/// Up to this depth (surfaces and scatterings) a path that a gathered lobe has sent survives surely
/// while it carries at least kFullWeight of what it began with; from this depth on, with the
/// probability that it carries.
inline constexpr int kRouletteDepth = 6;
inline constexpr float kFullWeight = 0.1f;

/// The weight with which a path survives surely, at any depth, while only specular surfaces and
/// followed lobes lie behind it.  The lights that it may run into are hundreds of times as bright
/// as what other paths find, so few survivors of large weight would be fireflies.
inline constexpr float kSeenWeight = 0.05f;

/// The depth from which on also paths that have lost nothing are ended, with probability 0.001:
/// between perfect mirrors nothing else would end them.  It is large because light caught in glass
/// or in a white room leaves after hundreds of reflections.  The probability is small because,
/// where each reflection keeps a share a, the square of what the surviving paths stand for adds up
/// only while the survival probability is above a^2.
inline constexpr int kEndlessDepth = 512;
inline constexpr float kEndlessProbability = 0.999f;

/// Returns the probability that Russian roulette lets a path continue, docs/light_transport.md
/// (14).  behind: what lies between the eye and its ray.  depth: surfaces and scatterings behind
/// it.  carried: the largest channel of its throughput relative to the start, times the square of
/// the index of refraction around it, as radiance scales with that.
inline float survival_probability(EyePathClass behind, int depth, float carried)
{
    const float gathered = depth < kRouletteDepth ? kFullWeight : 1.0f;
    const float full = is_gathered(behind) ? gathered : kSeenWeight;
    return std::min(depth < kEndlessDepth ? 1.0f : kEndlessProbability, carried / full);
}

/// Plays Russian roulette: returns false if it has ended the path, else divides the throughput by
/// the probability. Draws a number only where the probability is below one.
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
