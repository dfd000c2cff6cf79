#pragma once

#include "common/math/random.h"
#include "common/scene/scene.h"
#include "render/lobes/bsdf.h"

#include <vector>

namespace hipmap {

/// A sphere around specular faces.
struct TargetSphere {
    glm::vec3 centre;
    float radius = 0.0f; ///< scene units, above zero
};

/// Spheres that together hold every face with a specular lobe: where light must go first if it is
/// to make a caustic (Jensen 1996, projection maps).  Empty: the scene has no such face.
/// At most 32, however many faces there are.  bsdfs: of the materials.  Cost: linear in faces.
std::vector<TargetSphere> find_specular_targets(const Scene& scene, const std::vector<Bsdf>& bsdfs);

/// A ray towards some sphere.
struct AimedRay {
    glm::vec3 direction; ///< unit
    float weight = 0.0f; ///< 1 over its density per solid angle; 0: the ray is not to be sent
};

/// Where a light shines at all.
struct LightCone {
    glm::vec3 axis{0, 0, 1}; ///< unit
    float half_angle = 4.0f; ///< radians; at least pi: everywhere
};

/// Draws a direction from a point, uniformly from the union of the cones around the spheres.
/// docs/light_transport.md (15).  Cost: linear in spheres. Spheres that the light's cone misses are
/// left out.
AimedRay aim_from_point(const std::vector<TargetSphere>& targets, const glm::vec3& origin,
                        const LightCone& light, RandomSequence& random);

/// A point in the cylinders around the spheres along a direction.
struct AimedPoint {
    glm::vec3 position;
    float weight = 0.0f; ///< 1 over its density per area across the direction, or 0 as above
};

/// Draws a point by which parallel light along `direction` (unit) passes into some sphere,
/// docs/light_transport.md (15).  There must be a sphere.  Cost: linear in spheres.
AimedPoint aim_parallel(const std::vector<TargetSphere>& targets, const glm::vec3& direction,
                        RandomSequence& random);

} // namespace hipmap
