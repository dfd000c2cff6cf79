#pragma once

#include "common/math/random.h"
#include "common/rays/embree_scene.h"
#include "preprocess/prediction/mean_material.h"

namespace hipmap {

/// A sphere in scene units.
struct BoundingSphere {
    glm::vec3 centre{0.0f};
    float radius = 0.0f;
};

/// The start of a light path.  power: by channel, of any scale.
struct LightStart {
    Ray ray;
    Rgb power{0.0f}; ///< black: the light sends nothing this way
};

/// Where a light sends light from, and which ways.
struct LightPoint {
    Rgb power{1.0f};
    bool far = false; ///< parallel light along `axis`
    glm::vec3 position{0.0f};
    glm::vec3 axis{0, 0, 1}; ///< unit
    float cos_reach = -1.0f; ///< of the widest angle to the axis that light goes
    bool by_cosine = false;  ///< in proportion to the cosine to the axis, else evenly
};

/// A light of a scene: an analytic light, the emissive faces of an object, or the sky.
struct LightSource {
    enum class Kind : std::uint8_t { point, area, sun, faces, sky };
    Kind kind = Kind::point;
    LightPoint at;        ///< of faces: none; of the sky: `power` alone
    double power = 0;     ///< the largest channel, by which paths are shared out
    float size = 0;       ///< of a point: radius of the sphere; of a sun: half angle, radians
    bool is_disc = false; ///< an area: of an ellipse
    glm::vec3 half_right{0.0f}, half_up{0.0f}; ///< an area's
    std::vector<FaceId> faces;                 ///< that emit
    std::vector<double> cumulative;            ///< [faces] of their powers
};

/// The lights of a scene.  Borrows mesh and materials.
struct MeanLights {
    const TriangleMesh* mesh = nullptr;
    std::span<const MeanMaterial> materials;
    BoundingSphere scene; ///< around all faces
    std::vector<LightSource> lights;
    std::vector<double> cumulative; ///< [lights] of the shares of paths; the last is 1
};

/// Collects the lights that emit.  Nine tenths of the paths are shared out by power and a tenth
/// evenly, as in `render`.  An environment map counts as an even sky, a luminaire's measured
/// distribution as an even cone, and emissive media not at all.  materials: [M] of the scene, to
/// outlive the result.  Linear.
MeanLights collect_mean_lights(const Scene& scene, std::span<const MeanMaterial> materials);

/// Draws where the light of path `path` of `paths` starts; there must be a light.  Lights get
/// consecutive paths.
LightPoint draw_light_point(const MeanLights& sources, double path, RandomSequence& random);

/// Draws a ray from there.
LightStart draw_start(const MeanLights& sources, const LightPoint& point, RandomSequence& random);

/// Draws a ray from there towards one of some spheres, evenly over the directions in which they are
/// seen.  There must be a sphere.
LightStart draw_aimed_start(const MeanLights& sources, const LightPoint& point,
                            std::span<const BoundingSphere> targets, RandomSequence& random);

} // namespace hipmap
