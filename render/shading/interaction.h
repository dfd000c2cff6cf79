#pragma once

#include "common/rays/surface_point.h"
#include "render/shading/render_scene.h"

namespace hipmap {

/// A ray that has met a surface.  Both normals lie on the side that the ray came from.
struct Interaction {
    SurfacePoint point;
    Bsdf bsdf;
    glm::vec3 back;           ///< unit, from the point to where the ray came from
    glm::vec3 normal;         ///< geometric
    glm::vec3 shading_normal; ///< its cosine with `back` is above zero
    float cosine = 1.0f;      ///< dot(back, shading_normal)
    bool front = true;        ///< the ray came from the front of the face
    bool solid = false;       ///< the face belongs to a closed surface
    float coverage = 1.0f;    ///< share of the light that the face stops there, above zero
    std::uint8_t side = 0;    ///< 0 or 1: of the connected surface, the same for all its faces
};

/// Cost: constant.  Thread-safe.
Interaction interact(const RenderScene& scene, const Ray& ray, const RayHit& hit);

/// The ray reflected by a mirror.
Ray mirror_ray(const Interaction& at);

/// The ray that goes on through the surface; eta as in SpecularLobes.
Ray transmitted_ray(const Interaction& at, float eta);

/// Absorption per scene unit beyond the surface, for a ray that was transmitted there.
Rgb absorption_beyond(const Interaction& at);

/// What is left after `distance` in an absorbing inside (Beer-Lambert), docs/light_transport.md
/// (8).
Rgb transmittance(const Rgb& absorption, float distance);

/// Veach's correction for particles at a surface with a shading normal, docs/light_transport.md
/// (9). towards: where the particle goes on, unit.
float particle_correction(const Interaction& at, const glm::vec3& towards);

} // namespace hipmap
