#pragma once

#include "render/shading/dispersion.h"

namespace hipmap {

/// Sets the index of refraction of a solid that transmits, where dielectrics lie in one another:
/// that of its inside over that before its front, docs/media.md (12).  Where one of them depends on
/// the wavelength, the path goes on with one, docs/light_transport.md (29). nanometres, carried: as
/// choose_wavelength has them.
void find_nested_index(const RenderScene& scene, Interaction& at, float& nanometres, Rgb& carried,
                       RandomSequence& random);

/// Does what a path needs of that wherever it meets a surface.  Thread-safe.
inline void find_index(const RenderScene& scene, Interaction& at, float& nanometres, Rgb& carried,
                       RandomSequence& random)
{
    if (at.bsdf.is_matt() || !at.solid)
        return;
    if (scene.has_nested() && at.bsdf.glass > 0)
        find_nested_index(scene, at, nanometres, carried, random);
    else
        disperse(at, nanometres, carried, random);
}

} // namespace hipmap
