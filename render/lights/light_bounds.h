#pragma once

#include "common/math/bounds.h"

#include <glm/glm.hpp>

namespace hipmap {

/// A point that receives light.
struct LightReceiver {
    glm::vec3 position{0.0f}; ///< scene units
    glm::vec3 normal{0.0f};   ///< unit, on the side that light may come from; zero: from all sides
};

/// Bounds of the light that some lights emit: from where, how much, and in which directions.
struct LightBounds {
    Bounds<glm::vec3> box;
    glm::vec3 axis{0, 0, 1}; ///< unit; of a cone that holds the directions the lights face
    float cos_spread = 1.0f; ///< of the cone's half angle, 0 to pi
    float cos_reach = 0.0f;  ///< of the angle beyond the cone that light reaches, 0 to pi/2
    bool both_sides = false; ///< they emit along the opposite directions too
    double power = 0.0;      ///< in any unit that all have in common
};

/// Returns the bounds of two groups of lights together.  O(1).
LightBounds together(const LightBounds& a, const LightBounds& b);

/// Estimates how much of the lights' power may arrive at a receiver, docs/light_transport.md (25);
/// lights are chosen with probabilities in proportion to it.  Zero only if no light can arrive, or
/// if the receiver is at the position of a light without size.
double importance(const LightBounds& lights, const LightReceiver& at);

/// Returns whether a ray may meet the sphere around the box.  direction: unit.
bool may_meet(const Bounds<glm::vec3>& box, const glm::vec3& origin, const glm::vec3& direction);

/// Returns the cost, up to a factor, of a group of lights for a sampler that cannot tell them
/// apart: power times the square of its size times the solid angle it emits into.  Source: Conty
/// Estevez and Kulla 2018, section 4.4; the diagonal of the box replaces its area, which is zero
/// for lights in a row.
double spread_cost(const LightBounds& lights);

} // namespace hipmap
