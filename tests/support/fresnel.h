#pragma once

#include <cmath>

namespace hipmap {

/// Reflectance of a smooth interface for unpolarised light: the mean of Fresnel's two.
/// eta: index behind over index before, above 1.
inline double fresnel(double cosine, double eta)
{
    const double behind = std::sqrt(1 - (1 - cosine * cosine) / (eta * eta));
    const double across = (cosine - eta * behind) / (cosine + eta * behind);
    const double along = (eta * cosine - behind) / (eta * cosine + behind);
    return (across * across + along * along) / 2;
}

/// What goes on through a slab of glass, all inner reflections added up.  reflectance: of each
/// side; passed: what the inside leaves of light from one side to the other.
inline double through_slab(double reflectance, double passed)
{
    const double once = (1 - reflectance) * (1 - reflectance) * passed;
    return once / (1 - reflectance * reflectance * passed * passed);
}

/// What leaves a ball of glass of light that strikes it at one angle: the first reflection and what
/// comes out at each that follows.  Both as above; every chord of a path in a ball is as long.
inline double out_of_ball(double reflectance, double passed)
{
    const double once = (1 - reflectance) * (1 - reflectance) * passed;
    return reflectance + once / (1 - reflectance * passed);
}

/// Returns what leaves a ball of radius 1 along a ray that passes its middle at `offset`, below 1.
/// absorption: per radius.
inline double out_of_ball_at(double offset, double eta, double absorption)
{
    const double chord = 2 * std::sqrt(1 - offset * offset / (eta * eta));
    return out_of_ball(fresnel(std::sqrt(1 - offset * offset), eta), std::exp(-absorption * chord));
}

} // namespace hipmap
