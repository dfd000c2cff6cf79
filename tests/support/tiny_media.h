#pragma once

#include "tests/support/tiny_scenes.h"

namespace hipmap::tiny {

/// A medium without a surface.
inline Material fog(const Medium& medium)
{
    Material out;
    out.boundary = false;
    out.absorption = medium.absorption;
    out.scattering = medium.scattering;
    out.medium_emission = medium.emission;
    out.phase = medium.phase;
    out.density = medium.density;
    return out;
}

/// A unit cube of the medium, of which a square about its middle is looked at from above.
inline Scene cube_of(const Medium& medium, float side = 0.5f)
{
    Scene scene = make_scene(cube());
    scene.materials[0] = fog(medium);
    scene.cameras[0] = square_view(glm::vec3(0), {0, -1, 0}, side, 2);
    return scene;
}

} // namespace hipmap::tiny
