#pragma once

#include "common/math/random.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <vector>

namespace hipmap {

/// A sphere that light is aimed at.
struct TargetSphere {
    glm::vec3 centre;
    float radius = 0.0f; ///< scene units, above zero
};

/// Target spheres that a scene has at most.
inline constexpr std::size_t kMostTargets = 32;

/// A ray aimed at one of the target spheres.
struct AimedRay {
    glm::vec3 direction; ///< unit
    float weight = 0.0f; ///< 1 over its pdf per solid angle; 0: the ray is not to be sent
};

/// The directions into which a light emits.
struct LightCone {
    glm::vec3 axis{0, 0, 1}; ///< unit
    float half_angle = 4.0f; ///< radians; at least pi: everywhere
};

/// Draws a direction from a point, uniformly from the union of the cones around the spheres,
/// docs/light_transport.md (15).  Spheres that the light's cone misses are left out.  Cost: linear
/// in spheres, at most kMostTargets.
AimedRay aim_from_point(const std::vector<TargetSphere>& targets, const glm::vec3& origin,
                        const LightCone& light, RandomSequence& random);

/// A point in the cylinders around the spheres along a direction.
struct AimedPoint {
    glm::vec3 position;
    float weight = 0.0f; ///< 1 over its pdf per area across the direction; 0: it is not to be used
};

/// Draws a point through which parallel light along `direction` (unit) enters some sphere,
/// docs/light_transport.md (15).  There must be a sphere.  Cost: linear in spheres.
AimedPoint aim_parallel(const std::vector<TargetSphere>& targets, const glm::vec3& direction,
                        RandomSequence& random);

} // namespace hipmap
