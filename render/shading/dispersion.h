#pragma once

#include "common/math/random.h"
#include "render/shading/interaction.h"

namespace hipmap {

/// Light of one wavelength, drawn from the visible spectrum.
struct WavelengthSample {
    float nanometres = 0.0f;
    Rgb weight{1.0f}; ///< of light that goes on at that wavelength alone; its mean is white
};

/// Draws a wavelength by one uniform number, in proportion to the mean of the channels' responses:
/// the channels of a weight add up to 3.  docs/light_transport.md (29).  Cost: a search in a table
/// of 340, made when first asked for.  Thread-safe.
WavelengthSample sample_wavelength(float u);

/// Returns the index of refraction at a wavelength by Cauchy's formula, at least 1; as
/// KHR_materials_dispersion has it, docs/light_transport.md (30).  ior: at 587.6 nm.  dispersion:
/// 20 / Abbe number.
float dispersed_index(float ior, float dispersion, float nanometres);

/// Restricts a path to one wavelength: draws it if the path has none (0) yet, and multiplies
/// `carried` (throughput or power) by its weight.  The path must reset it to 0 where it leaves by a
/// gathered lobe.
void choose_wavelength(float& nanometres, Rgb& carried, RandomSequence& random);

/// Restricts the path to one wavelength at a dispersive solid, and sets the index of refraction.
void disperse_here(Interaction& at, float& nanometres, Rgb& carried, RandomSequence& random);

/// Calls disperse_here wherever the solid that a path meets is dispersive.
inline void disperse(Interaction& at, float& nanometres, Rgb& carried, RandomSequence& random)
{
    if (at.bsdf().dispersion > 0 && at.solid)
        disperse_here(at, nanometres, carried, random);
}

} // namespace hipmap
