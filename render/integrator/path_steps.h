#pragma once

#include "common/math/random.h"
#include "render/effects/light_classes.h"
#include "render/integrator/direct_light.h"

namespace hipmap {

/// A path on its way from the eye, docs/light_transport.md (14).
struct Path {
    Ray ray;
    Rgb weight{1.0f};
    Rgb absorption{0.0f}; ///< of what the ray travels in, where there are no media
    float index2 = 1.0f;  ///< square of the index of what the ray travels in
    RaySource source;
    float nanometres = 0; ///< of the light followed; 0: all
    bool gathers = false; ///< a gathered lobe is behind it
    bool straight = true; ///< nothing else is since

    /// Light that the ray runs into counts: else it is of a class left out.
    bool sees_lights(const LightClasses& light) const
    {
        return light.caustic || !gathers || straight;
    }
};

/// False: Russian roulette ended it.  depth: surfaces and scatterings behind it.
bool survives(int depth, Path& path, RandomSequence& random);

/// Adds what the path sees of and at a surface, and sends it on by one of the lobes; false: it ends
/// there.  distance: of the surface from where the ray was sent.
bool pass_surface(const RenderScene& scene, const Interaction& at, float distance,
                  const LightClasses& light, RandomSequence& random, Path& path, Rgb& radiance);

} // namespace hipmap
