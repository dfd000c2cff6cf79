#pragma once

#include "render/shading/scatter.h"

namespace hipmap {

/// The probabilities with which a path goes on from a surface; they add up to one, or are all zero
/// if it is black.  They depend on the surface and where it is seen from alone.
struct WaysOn {
    float gathered = 0.0f, followed = 0.0f, mirror = 0.0f, transmit = 0.0f;
    SpecularLobes specular;

    float spread() const { return gathered + followed; }
};

/// Returns the ways on from a surface.
WaysOn ways_on(const Interaction& at);

/// All lobes that are not specular, between two directions.
struct SpreadValue {
    Rgb value{0.0f};      ///< f |cos in| of radiance, from `in` to at.back
    float pdf = 0.0f;     ///< per steradian, of drawing `in` as seen from at.back
    float reverse = 0.0f; ///< per steradian, of drawing at.back as seen from `in`
};

/// Evaluates the spread lobes of a surface.  hit: that led to `at`.  in: unit, away from the
/// surface.
SpreadValue spread_value(const RenderScene& scene, const Interaction& at, const WaysOn& ways,
                         const RayHit& hit, const glm::vec3& in);

/// Returns what turns SpreadValue::value into that of a particle from at.back to `in`, with the
/// cosine of `in` to the geometric normal.
float particle_factor(const Interaction& at, const glm::vec3& in);

} // namespace hipmap
