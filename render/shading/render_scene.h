#pragma once

#include "common/partition/partition.h"
#include "common/rays/embree_scene.h"
#include "common/scene/scene.h"
#include "render/lights/collect_lights.h"
#include "render/media/media_set.h"
#include "render/shading/make_bsdf.h"
#include "render/shading/specular_targets.h"

#include <vector>

namespace hipmap {

/// A scene with everything that rendering derives from it.  Borrows scene and partition, which must
/// outlive it.  Read-only: any number of threads may use it.
struct RenderScene {
    const Scene& scene;
    const Partition& partition;
    Opacity opacity; ///< of faces; empty: all stop all light
    EmbreeScene rays;
    std::vector<Bsdf> bsdfs; ///< [M] by the materials' factors
    std::vector<std::uint8_t>
        varying;                     ///< [M] 1: textures or vertices' colours multiply the factors
    std::vector<std::uint8_t> bumpy; ///< [M] 1: a texture tilts a shading normal
    std::vector<std::uint8_t> plain; ///< [M] 1: neither, isotropic, and faces stop all light
    bool all_plain = false;          ///< all materials are
    std::vector<TargetSphere> specular_targets; ///< that light is aimed at to make caustics
    std::optional<MediaSet> media;  ///< none: nothing but surfaces and glass that absorbs
    EnvironmentMap environment_map; ///< empty: none
    SurfaceEmission surface_emission;
    LightSet lights;
    std::vector<std::uint8_t> enclosed_lights; ///< [lights] 1: a target sphere holds the light
    bool lit_by_faces = false;                 ///< no light but emissive meshes and media emits
    bool clear = false; ///< nothing lies between surfaces: no medium, no glass that absorbs, no
                        ///<   light that rays can run into
    bool directional = false; ///< photons are weighed by the direction they came from: some surface
                              ///<   gathers by a lobe that is not separable

    /// Builds the scene.  map: the environment map that the scene names, or an empty one.
    RenderScene(const Scene& from_scene, const Partition& from_partition, EnvironmentMap map = {});
    RenderScene(RenderScene&&) = delete; // media borrow the rays, lights the rest

    const TriangleMesh& mesh() const { return scene.mesh; }
    bool has_media() const { return media.has_value(); }
    /// Returns whether the scene has nested dielectrics.
    bool has_nested() const { return has_media() && media->nested; }
    /// Returns whether the material is the same at all points.
    bool is_plain(MaterialId material) const { return all_plain || plain[material] != 0; }
};

/// Returns the radiance that a point of a face emits, from the sides that emit.
Rgb emission_at(const RenderScene& scene, FaceId face, const glm::vec2& barycentric);

/// Returns whether the side of a face that `direction` leaves (unit, away from the face) may emit.
inline bool emits_towards(const Bsdf& bsdf, const SurfacePoint& point, const glm::vec3& direction)
{
    return bsdf.emits_behind || glm::dot(direction, point.geometric_normal) > 0;
}

/// Returns the radiance that a face emits towards `direction` (unit, away from the face).
inline Rgb emitted_radiance(const Bsdf& bsdf, const SurfacePoint& point, const glm::vec3& direction)
{
    return emits_towards(bsdf, point, direction) ? bsdf.emission : Rgb(0);
}

} // namespace hipmap
