#pragma once

#include "common/math/random.h"
#include "common/rays/surface_point.h"
#include "common/scene/scene.h"
#include "render/shading/bsdf.h"

#include <optional>
#include <vector>

namespace hipmap {

/// Everything that shines in a scene.  Powers are in W divided by metres_per_unit^2 (all lengths
/// are scene units, so that power / area in square scene units is W/m2).
struct LightSet {
    std::vector<PunctualLight> punctual;
    std::vector<FaceId> emissive_faces;
    std::vector<double>
        cumulative;              ///< [emissive_faces] running sum of selection weights, ends at 1
    std::vector<float> density;  ///< [F or 0] per face: chance of being selected over its area
    double emissive_power = 0.0; ///< largest channel, of all emissive faces together
    Rgb environment{0.0f};
    glm::vec3 centre{0.0f}; ///< of a sphere around all faces
    float radius = 0.0f;
};

/// Borrows nothing.  Emissive faces are selected in proportion to their power, by
/// pictures and vertices' colours on average over each.  O(F).
LightSet collect_lights(const Scene& scene, const std::vector<Bsdf>& bsdfs);

/// A point of an emissive face.
struct EmissivePoint {
    SurfacePoint surface;
    glm::vec2 barycentric{0.0f}; ///< as in RayHit
    float density = 0.0f;        ///< per square scene unit, over all emissive faces
};

/// Selects by power, then area-uniformly.  There must be an emissive face.
EmissivePoint sample_emissive_point(const LightSet& lights, const TriangleMesh& mesh, double u_face,
                                    const glm::vec2& u);

/// The same by two numbers instead of three, the first of which selects too: for no more than some
/// tens of faces, as little of it is left then.
EmissivePoint sample_emissive_point(const LightSet& lights, const TriangleMesh& mesh, glm::vec2 u);

/// Whether the side of a face that `direction` leaves (unit, away from the face) may emit.
bool shines_towards(const Bsdf& bsdf, const SurfacePoint& point, const glm::vec3& direction);

/// Radiance that a face emits towards `direction` (unit, away from the face).
Rgb emitted_radiance(const Bsdf& bsdf, const SurfacePoint& point, const glm::vec3& direction);

/// Radiant intensity of a spot or point light along `direction` (unit, away from it).
Rgb light_intensity(const PunctualLight& light, const glm::vec3& direction);

/// Power of a punctual light that can reach a scene within LightSet's sphere.
Rgb light_power(const PunctualLight& light, float scene_radius);

} // namespace hipmap
