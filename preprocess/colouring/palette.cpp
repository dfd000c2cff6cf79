#include "preprocess/colouring/palette.h"

#include "common/image/colour_scale.h"

#include <cmath>
#include <numbers>

namespace hipmap {

namespace {

constexpr std::uint32_t kHues = 12;
constexpr double kGoldenAngle = 137.50776405003785;

} // namespace

Rgb palette_colour(std::uint32_t index)
{
    if (index >= kDistinctColours)
        return oklch(0.4 + 0.5 * std::fmod(index * std::numbers::phi, 1.0), 0.1,
                     std::fmod(index * kGoldenAngle, 360.0));
    // Five twelfths of the circle from one to the next, so that small numbers contrast.
    const std::uint32_t hue = index * 5 % kHues;
    const bool second_round = index >= kHues;
    return oklch(second_round ? 0.52 : 0.76, 0.14, hue * (360.0 / kHues) + 25);
}

} // namespace hipmap
