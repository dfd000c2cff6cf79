#pragma once

#include "common/rays/surface_point.h"
#include "render/shading/render_scene.h"

#include <glm/exponential.hpp>

#include <optional>

namespace hipmap {

/// The surface of a point in a medium: it has no lobes.
inline const Bsdf kNoSurface;

/// A ray that has met a surface, or a medium that scatters it.  Both normals lie on the side that
/// the ray came from; in a medium they are zero.
struct Interaction {
    SurfacePoint point;
    glm::vec3 back;           ///< unit, from the point to where the ray came from
    glm::vec3 normal;         ///< geometric
    glm::vec3 shading_normal; ///< its cosine with `back` is above zero
    glm::vec3 coat_normal{0}; ///< of a clear coat that has one of its own; zero: the same
    glm::vec3 tangent{0};     ///< unit, across the shading normal; zero: there is none
    float cosine = 1.0f;      ///< dot(back, shading_normal)
    bool front = true;        ///< the ray came from the front of the face
    bool solid = false;       ///< the face belongs to a closed surface
    float ior = 1.0f;         ///< index of refraction behind the front of the face over before it
    float opacity = 1.0f;     ///< share of the light that the face stops there
    std::uint8_t side = 0;    ///< 0 or 1: of the connected surface, the same for all its faces
    const PhaseFunction* phase = nullptr; ///< of a medium; null: at a surface.  Borrowed
    const MediumStack* inside = nullptr;  ///< the media of the ray; null: the scene has none
    const Bsdf* worn = &kNoSurface;       ///< of the material by its factors.  Borrowed
    std::optional<Bsdf> own;              ///< instead of that, where textures change it

    const Bsdf& bsdf() const { return own ? *own : *worn; }
    /// Returns the cosines of `back`.
    Incidence seen() const;
    /// Returns whether the surface has only a diffuse lobe, which may be black.
    bool is_diffuse() const { return bsdf().is_diffuse; }
    /// Returns whether photons are gathered here, at a surface or in a medium.
    bool gathers() const { return phase != nullptr || bsdf().gathers; }
    bool follows() const { return bsdf().follows; }
    bool has_coat_normal() const { return coat_normal != glm::vec3(0); }
    bool in_media() const { return inside != nullptr; }
};

/// Computes the interaction at a hit.  Cost: constant.  Thread-safe.
Interaction interact(const RenderScene& scene, const Ray& ray, const RayHit& hit);

/// Makes an interaction at a point of a medium.  back: as in Interaction.  Borrows the other two.
Interaction scattering_point(const glm::vec3& position, const glm::vec3& back,
                             const PhaseFunction& phase, const MediumStack& inside);

/// Returns the media of a ray that leaves the point; they differ on the two sides of a surface.
/// Nothing where there are no media.
MediumStack medium_stack_towards(const RenderScene& scene, const Interaction& at,
                                 const glm::vec3& direction);

/// Returns the transmittance along a shadow ray from the point: 0 or 1, or less than 1 with media
/// in the way.
Rgb unoccluded_in_media(const RenderScene& scene, const Interaction& at, const Ray& shadow);
inline Rgb unoccluded(const RenderScene& scene, const Interaction& at, const Ray& shadow)
{
    return at.in_media() ? unoccluded_in_media(scene, at, shadow)
                         : Rgb(scene.rays.occluded(shadow) ? 0.0f : 1.0f);
}

/// Returns the first surface that a ray from the point meets; multiplies `left` by the
/// transmittance of media on the way.
std::optional<RayHit> first_surface(const RenderScene& scene, const Interaction& at, const Ray& ray,
                                    Rgb& left);

/// The ray reflected by a mirror.
Ray mirror_ray(const Interaction& at);

/// Returns the cosines of a unit direction away from the surface.  cosine: to the shading normal.
inline Incidence incidence(const Interaction& at, const glm::vec3& direction, float cosine)
{
    return at.has_coat_normal() ? Incidence(cosine, glm::dot(direction, at.coat_normal))
                                : Incidence(cosine);
}

inline Incidence Interaction::seen() const
{
    return incidence(*this, back, cosine);
}

/// Returns the index of refraction on the transmitted side over that on the side of `back`.
inline float eta_behind(const Interaction& at)
{
    return at.solid && !at.front ? 1 / at.ior : at.ior;
}

/// Returns the surface as a lobe at a depth is seen from `back`.
inline LobeView view_of(const Interaction& at, Depth depth)
{
    LobeView out{at.shading_normal, at.back, at.cosine, at.tangent, eta_behind(at), at.solid};
    if (depth == Depth::clearcoat && at.has_coat_normal()) {
        out.normal = at.coat_normal;
        out.cosine = glm::dot(at.back, at.coat_normal);
    }
    return out;
}

/// Returns the ray that crosses the surface; eta as in SpecularLobes.
Ray transmitted_ray(const Interaction& at, float eta);

/// Returns the absorption per scene unit behind the surface, for a ray that was transmitted there;
/// none where the scene's media have it.
Rgb absorption_behind(const Interaction& at);

/// Returns the transmittance of `distance` in an absorbing inside (Beer-Lambert),
/// docs/light_transport.md (8).
inline Rgb transmittance(const Rgb& absorption, float distance)
{
    return is_black(absorption) ? Rgb(1) : glm::exp(-absorption * distance);
}

/// Multiplies a throughput by the transmittance of `distance`.
inline void absorb(const Rgb& absorption, float distance, Rgb& throughput)
{
    if (!is_black(absorption))
        throughput *= glm::exp(-absorption * distance);
}

/// Returns Veach's correction for particles at a surface with a shading normal,
/// docs/light_transport.md (9). towards: the direction in which the particle continues, unit.
float particle_correction(const Interaction& at, const glm::vec3& towards);

/// Returns the same for a mirror or glass, where it has a limit, docs/light_transport.md (9).
float specular_correction(const Interaction& at, const glm::vec3& towards);

/// Returns the share that a mirror or glass leaves to an eye path of what comes from a direction,
/// by that limit: 1 but where light meets a face with a shading normal at a grazing angle.  from:
/// unit.
float specular_share(const Interaction& at, const glm::vec3& from);

} // namespace hipmap
