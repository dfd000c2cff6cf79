#include "common/image/colour_scale.h"

#include <numbers>

namespace hipmap {

namespace {

glm::dvec3 linear_from_oklch(double lightness, double chroma, double hue_deg)
{
    const double hue = hue_deg * std::numbers::pi / 180;
    const double a = chroma * std::cos(hue);
    const double b = chroma * std::sin(hue);
    const auto cube = [](double x) { return x * x * x; };
    const double l = cube(lightness + 0.3963377774 * a + 0.2158037573 * b);
    const double m = cube(lightness - 0.1055613458 * a - 0.0638541728 * b);
    const double s = cube(lightness - 0.0894841775 * a - 1.2914855480 * b);
    return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
            -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
            -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

bool displayable(const glm::dvec3& c)
{
    return std::min({c.x, c.y, c.z}) >= 0 && std::max({c.x, c.y, c.z}) <= 1;
}

} // namespace

Rgb oklch(double lightness, double chroma, double hue_deg)
{
    constexpr int kSteps = 32;
    for (int step = kSteps; step > 0; --step) {
        const glm::dvec3 colour = linear_from_oklch(lightness, chroma * step / kSteps, hue_deg);
        if (displayable(colour))
            return Rgb(colour);
    }
    return Rgb(static_cast<float>(lightness * lightness * lightness));
}

Rgb scale_colour(double t)
{
    t = std::clamp(t, 0.0, 1.0);
    return oklch(0.28 + 0.64 * t, 0.15, 300 - 190 * t);
}

} // namespace hipmap
