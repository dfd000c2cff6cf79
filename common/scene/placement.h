#pragma once

#include <glm/glm.hpp>

namespace hipmap {

/// What turns the vertices of a mesh into the world's.
struct Placement {
    glm::dmat4 points{1.0};
    glm::dmat3 normals{1.0}; ///< inverse transpose up to a positive factor
    bool mirrored = false;   ///< the transform turns a right-handed frame into a left-handed one
};

/// Returns the placement by a transform, which may be singular.
Placement placement_of(const glm::dmat4& to_world);

/// Returns the unit vector along v; zero where v is zero or not finite.
glm::vec3 unit_or_zero(const glm::dvec3& v);

/// Returns a tangent of glTF in the world: w is its handedness; zero where it vanishes.
glm::vec4 place_tangent(const glm::vec4& tangent, const Placement& placement);

} // namespace hipmap
