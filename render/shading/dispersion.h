#pragma once

#include "common/math/random.h"
#include "render/shading/interaction.h"

namespace hipmap {

/// Light of one wavelength, drawn from all that is seen.
struct WavelengthSample {
    float nanometres = 0.0f;
    Rgb weight{1.0f}; ///< of light that goes on at that wavelength alone; its mean is white
};

/// By one uniform number, in proportion to the mean of the channels' responses: the channels of a
/// weight add up to 3.  docs/light_transport.md (29).  Cost: a search in a table of 340, made when
/// first asked for.  Thread-safe.
WavelengthSample sample_wavelength(float u);

/// Index of refraction at a wavelength by Cauchy's formula, at least 1; as KHR_materials_dispersion
/// has it, docs/light_transport.md (30).  ior: at 587.6 nm.  dispersion: 20 / Abbe number.
float dispersed_index(float ior, float dispersion, float nanometres);

/// Goes on with a path of one wavelength: draws it if the path has none (0) yet, and multiplies
/// `carried` (weight or power) by what that means.  The path is to set it to 0 where it leaves by a
/// gathered lobe.
void choose_wavelength(float& nanometres, Rgb& carried, RandomSequence& random);

/// Does so at a solid that bends colours differently, and sets the index.
void disperse_here(Interaction& at, float& nanometres, Rgb& carried, RandomSequence& random);

/// The same wherever a path meets a surface; nothing if colours go the same way there.
inline void disperse(Interaction& at, float& nanometres, Rgb& carried, RandomSequence& random)
{
    if (!kMattOnly && at.bsdf().dispersion > 0 && at.solid)
        disperse_here(at, nanometres, carried, random);
}

} // namespace hipmap
