#pragma once

#include "common/math/random.h"
#include "common/rays/surface_point.h"
#include "common/scene/scene.h"
#include "render/lobes/bsdf.h"
#include "render/media/matt_only.h"
#include "render/shading/light_tree.h"
#include "render/shading/sky_picture.h"

#include <optional>
#include <vector>

namespace hipmap {

/// Everything that shines in a scene.  Powers are in W divided by metres_per_unit^2 (all lengths
/// are scene units, so that power / area in square scene units is W/m2).
struct LightSet {
    std::vector<PunctualLight> punctual;
    std::vector<AreaLight> area;
    std::vector<FaceId> emissive_faces;
    std::vector<double>
        cumulative;              ///< [emissive_faces] running sum of selection weights, ends at 1
    std::vector<float> density;  ///< [F or 0] per face: chance of being selected over its area
    double emissive_power = 0.0; ///< largest channel, of all emissive faces together
    LightTree face_tree;         ///< over emissive_faces; empty if they are few
    std::vector<std::uint32_t> place_of_face; ///< [F, or 0 if they are few] in emissive_faces
    LightTree lamp_tree;                      ///< over chosen_lamps
    std::vector<std::uint32_t> chosen_lamps;  ///< lamps (lamps.h), if they are many, but for suns
    std::vector<std::uint32_t> other_lamps;   ///< all of which are sampled
    std::vector<std::uint32_t> sized_lamps;   ///< those of the others that rays can run into
    bool chosen_have_size = false;            ///< some of chosen_lamps are such
    bool has_lamps = false;                   ///< some lamp shines
    bool has_sized_lamps = false;             ///< rays can run into some
    Rgb environment{0.0f};                    ///< of a uniform sky
    SkyPicture sky;                           ///< instead of that, unless empty
    glm::vec3 centre{0.0f};                   ///< of a sphere around all faces
    float radius = 0.0f;
};

/// Light comes from beyond the scene, but for suns.
bool has_sky(const LightSet& lights);

/// There are lamps that shine.
inline bool has_lamps(const LightSet& lights)
{
    return !kMattOnly && lights.has_lamps;
}

/// There are such that rays can run into.
inline bool has_sized_lamps(const LightSet& lights)
{
    return !kMattOnly && lights.has_sized_lamps;
}

/// The sky is a picture.
inline bool has_sky_picture(const LightSet& lights)
{
    return !kMattOnly && !lights.sky.empty();
}

/// There is some light that a ray may run into.
bool can_be_met(const LightSet& lights);

/// Its radiance from a direction (unit, away from the scene).
Rgb sky_radiance(const LightSet& lights, const glm::vec3& direction);

/// Borrows nothing; without a picture of the sky.  Emissive faces are selected in proportion to
/// their power, by pictures and vertices' colours on average over each.  O(F).
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

/// The same for light at a receiver: of many faces, one is chosen by their importance there; of
/// few, one by power and by the first of the two numbers that give the point on it, so that samples
/// that are stratified are so over all of them.  density 0: no face can light the receiver.
EmissivePoint sample_emissive_point(const LightSet& lights, const TriangleMesh& mesh,
                                    const LightReceiver& at, RandomSequence& random);

/// Chance per square scene unit that this draws a point of an emissive face.
float emissive_density(const LightSet& lights, const TriangleMesh& mesh, const LightReceiver& at,
                       FaceId face);

/// Whether the side of a face that `direction` leaves (unit, away from the face) may emit.
bool shines_towards(const Bsdf& bsdf, const SurfacePoint& point, const glm::vec3& direction);

/// Radiance that a face emits towards `direction` (unit, away from the face).
Rgb emitted_radiance(const Bsdf& bsdf, const SurfacePoint& point, const glm::vec3& direction);

/// Radiant intensity of a spot or point light along `direction` (unit, away from it).
Rgb light_intensity(const PunctualLight& light, const glm::vec3& direction);

/// Power of a punctual light that can reach a scene within LightSet's sphere, whatever its size.
Rgb light_power(const PunctualLight& light, float scene_radius);

} // namespace hipmap
