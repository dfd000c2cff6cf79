#pragma once

#include "render/shading/dispersion.h"

namespace hipmap {

/// Sets the index of refraction of a solid that transmits and that a path has met.  For nested
/// dielectrics it is the index inside over that before its front, docs/media.md (12).  Where one of
/// them depends on the wavelength, the path is restricted to one wavelength,
/// docs/light_transport.md (29). nanometres, carried: as in choose_wavelength.
void find_index_here(const RenderScene& scene, Interaction& at, float& nanometres, Rgb& carried,
                     RandomSequence& random);

/// Calls find_index_here wherever a path meets a solid that transmits.  Thread-safe.
inline void find_index(const RenderScene& scene, Interaction& at, float& nanometres, Rgb& carried,
                       RandomSequence& random)
{
    if (!at.is_diffuse()) [[unlikely]]
        find_index_here(scene, at, nanometres, carried, random);
}

} // namespace hipmap
