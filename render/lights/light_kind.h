#pragma once

#include "common/math/random.h"
#include "common/math/rgb.h"
#include "common/rays/embree_scene.h"
#include "render/lights/aim.h"
#include "render/lights/light_bounds.h"

#include <cstdint>
#include <limits>
#include <optional>

namespace hipmap {

// Each kind of light is a plain struct in a file of its own, with a constant `kRole` and these free
// functions, which any number of threads may call:
//
//   sample_li            draws a direction from a receiver towards the light
//   intersect            finds the light along a ray, with the pdf by which sample_li draws the ray
//   can_be_met           whether intersect finds it along some ray
//   sample_emission      draws the start of a light path, with the whole power of the light
//   sample_aimed_emission  draws the start of a light path towards target spheres
//   power                W / metres_per_unit^2 that can reach the scene
//   bounds               what a light tree knows of the light; none: it is beyond the scene
//
// A kind whose light paths differ in colour may also have
//
//   path_power           mean of the largest channel of the paths' power; else that of `power`
//
// and one whose light comes from beyond the scene
//
//   primary_of           the random numbers by which sample_emission draws a path; those that
//                        it does not draw are `unused`
//   far_light            its direction and moments, if it fills a small part of the sky
//
// To add a kind: write its file, add it to `Light` (light.h) and make it from the scene
// (collect_lights.cpp).

/// How paths from the eye find a kind of light.
enum class LightRole : std::uint8_t {
    analytic,    ///< no faces: direct light samples it; rays from surfaces may run into it, the
                 ///<   eye does not see it
    surface,     ///< faces of the scene: direct light samples one face of all such lights
    environment, ///< beyond all faces: direct light samples it; every ray that leaves the scene
                 ///<   sees it
    medium,      ///< rays gather it on their way; photons of it count as scattered in a medium
};

/// Light that arrives at a receiver from a sampled direction.
struct LightSample {
    glm::vec3 direction{0.0f}; ///< unit, towards the light
    bool is_far = false;       ///< it comes from beyond the scene
    glm::vec3 point{0.0f};     ///< else from here
    Rgb light{0.0f};           ///< W/m2 across the direction, divided by `pdf` unless that is 0
    float pdf = 0.0f;          ///< of the direction, per solid angle; 0: the light has no size
};

/// A light that a ray meets.
struct LightHit {
    float distance = 0.0f; ///< infinite for a light beyond the scene
    Rgb radiance{0.0f};    ///< W/(m2 sr)
    float pdf = 0.0f;      ///< per solid angle, that `sample_li` at the ray's origin draws this
};

/// A light that fills a small part of the sky, by the integrals over directions of the largest
/// channel of its radiance, W/m2, and of its square.
struct FarLight {
    glm::vec3 towards{0.0f}; ///< unit
    double first = 0;
    double second = 0; ///< infinite: it has no size
};

/// The start of a light path.
struct EmittedPath {
    Ray ray;
    Rgb power{0.0f}; ///< W / metres_per_unit^2
    /// W/(m2 sr), that a ray which meets the light where the path starts would find; infinite: no
    /// ray can.
    Rgb radiance{std::numeric_limits<float>::infinity()};
    bool from_medium = false;
};

/// The place of a path among its light's paths, for lights that stratify them.
struct PathPlace {
    std::uint64_t place = 0; ///< below `paths`
    std::uint64_t paths = 1;
};

} // namespace hipmap
