#pragma once

#include "render/shading/dispersion.h"

namespace hipmap {

/// Sets the index of refraction of a solid that transmits and that a path has met.  Where
/// dielectrics lie in one another it is that of its inside over that before its front,
/// docs/media.md (12).  Where one of them depends on the wavelength, the path goes on with one,
/// docs/light_transport.md (29).
/// nanometres, carried: as choose_wavelength has them.
void find_index_here(const RenderScene& scene, Interaction& at, float& nanometres, Rgb& carried,
                     RandomSequence& random);

/// The same wherever a path meets a surface.  Thread-safe.
inline void find_index(const RenderScene& scene, Interaction& at, float& nanometres, Rgb& carried,
                       RandomSequence& random)
{
    if (!at.is_diffuse()) [[unlikely]]
        find_index_here(scene, at, nanometres, carried, random);
}

} // namespace hipmap
