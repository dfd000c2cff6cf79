#pragma once

#include "common/math/rgb.h"
#include "common/scene/scene.h"
#include "render/shading/textured_material.h"

#include <cstdint>
#include <vector>

namespace hipmap {

/// The one predicate that tells a specular lobe (followed, never stored) from a diffuse one, for
/// photons and eye paths alike.  A reflection rougher than this is taken into the diffuse lobe with
/// its whole albedo; a transmission rougher than this is followed as if it were smooth.
inline constexpr float kSpecularRoughness = 0.1f;
inline bool is_specular(float roughness)
{
    return roughness <= kSpecularRoughness;
}

/// A material, ready for shading.  docs/light_transport.md (1)-(4).
/// The diffuse lobe is separable: f(wi, wo) = diffuse / pi * coat_half(wi) * coat_half(wo).
struct Bsdf {
    Rgb diffuse{0.0f};   ///< the factor above, albedo where there is no coat
    bool coated = false; ///< a smooth dielectric lies over the diffuse lobe
    Rgb coat_f0{0.0f};   ///< its reflectance at normal and ...
    Rgb coat_f90{0.0f};  ///< ... grazing incidence, weighted by how much of the surface is coated
    Rgb coat_average{0.0f}; ///< its reflectance averaged over the cosine-weighted hemisphere
    float metal = 0.0f;     ///< share that is a smooth metal
    Rgb metal_f0{0.0f};
    float glass = 0.0f;         ///< share that is a smooth dielectric that transmits
    Rgb glass_tint{1.0f};       ///< transmitted at each crossing
    Rgb glass_reflection{1.0f}; ///< scale of its Fresnel reflection (KHR_materials_specular)
    float ior = 1.5f;
    float burley_roughness = -1; ///< of the diffuse lobe; below zero: Lambert
    Rgb absorption{0.0f};        ///< inside, per scene unit
    Rgb emission{0.0f};          ///< radiance, W/(m2 sr)
    bool emits_behind = false;

    bool has_diffuse() const { return !is_black(diffuse); }
};

/// The material at a point.
Bsdf make_bsdf(const Material& material, const MaterialPoint& at, DiffuseModel model);

/// One for each material of the scene, by its factors alone.
std::vector<Bsdf> make_bsdfs(const std::vector<Material>& materials, DiffuseModel model);

/// What the diffuse lobe is multiplied by for a pair of directions, docs/light_transport.md (13); 1
/// for Lambert.  normal: shading; all unit, the directions away from the surface.
float diffuse_shape(const Bsdf& bsdf, const glm::vec3& normal, const glm::vec3& wi,
                    const glm::vec3& wo);

/// 1 - F(wi): what of the light from (or to) a direction gets through the coat; 1 without a coat.
/// cosine: of the angle to the shading normal, [0, 1].
Rgb coat_half(const Bsdf& bsdf, float cosine);

/// The part of light along one direction that the diffuse lobe scatters over the whole hemisphere:
/// the integral of f(wi, wo) cos(wo) over wo.
Rgb diffuse_albedo(const Bsdf& bsdf, float cosine);

/// Reflectance of a smooth interface between dielectrics for unpolarised light; 1 at total
/// reflection. cosine: of incidence, [0, 1].  eta: index beyond the interface over index before it.
float fresnel_dielectric(float cosine, float eta);

/// The specular lobes for one direction, as shares of its light.
struct SpecularLobes {
    Rgb mirror{0.0f};
    Rgb transmit{0.0f};
    float eta = 1.0f; ///< index beyond the interface over index before it; 1 through a thin wall
};

/// cosine: as above.  front: the direction lies in front of the face.  solid: the face belongs to a
/// closed surface, so that glass refracts; otherwise it is a thin wall that light crosses straight.
SpecularLobes specular_lobes(const Bsdf& bsdf, float cosine, bool front, bool solid);

/// The direction beyond a smooth interface; away from the surface on the other side.
/// direction: unit, away from the surface on the side the light comes from; normal: unit, same
/// side. eta: as above; there must be no total reflection.
glm::vec3 refract(const glm::vec3& direction, const glm::vec3& normal, float eta);

/// Mirror image of `direction` about `normal`; both unit and away from the surface.
glm::vec3 reflect(const glm::vec3& direction, const glm::vec3& normal);

} // namespace hipmap
