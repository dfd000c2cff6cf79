#pragma once

#include "render/shading/make_bsdf.h"

namespace hipmap {

/// Returns whether any point of the material can have a specular lobe, which makes caustics.  bsdf:
/// by its factors.
bool may_be_specular(const Material& material, const Bsdf& bsdf);

/// Returns whether any point of the material may gather by a lobe that is not separable, so that
/// photons must keep the direction they came from.
bool may_gather_by_direction(const Material& material, const Bsdf& bsdf);

} // namespace hipmap
