#pragma once

#include "render/shading/bsdf.h"

namespace hipmap {

// What facets of metal reflect onto one another, which their own lobe loses, as a lobe of its own
// (Kulla and Conty 2017), docs/light_transport.md (33).  Cosines: to the shading normal, of
// directions above the surface.  Layers above take their part besides.

/// The factor of the lobe of a metal.  color: its F0.  alpha: width of the facets, above zero.
Rgb regained_by(const Rgb& color, float alpha);

/// f(wi, wo), per steradian; the same both ways.
Rgb regained_lobe(const Bsdf& bsdf, float cos_in, float cos_out);

/// Share of light along one direction that it sends on.
Rgb regained_albedo(const Bsdf& bsdf, float cosine);

} // namespace hipmap
