#pragma once

#include "common/math/rgb.h"

namespace hipmap {

// Light that facets of metal reflect onto one another, which a single reflection loses, as a lobe
// of its own (Kulla and Conty 2017), docs/light_transport.md (33).  Cosines: to the shading normal,
// of directions above the surface.  alpha: width of the facets, above zero.

/// Returns the factor of the lobe of a metal.  color: its reflectance at normal incidence.
Rgb multiple_factor(const Rgb& color, float alpha);

/// Returns f(wi, wo), per steradian; reciprocal.
Rgb multiple_scattering(const Rgb& factor, float cos_in, float cos_out, float alpha);

/// Returns the share of light along one direction that the lobe scatters.
Rgb multiple_albedo(const Rgb& factor, float cosine, float alpha);

} // namespace hipmap
