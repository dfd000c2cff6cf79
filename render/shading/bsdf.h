#pragma once

#include "common/math/rgb.h"
#include "common/scene/scene.h"
#include "render/media/matt_only.h"
#include "render/shading/textured_material.h"

#include <glm/geometric.hpp>

#include <cstdint>
#include <vector>

namespace hipmap {

/// Up to this roughness a reflection is a mirror's and glass is clear: the lobe is narrower than a
/// pixel.
inline constexpr float kMirrorRoughness = 0.02f;

/// Up to this roughness a glossy reflection is followed, as a mirror's is; above it is gathered
/// from photons.  Rough glass is always followed.  For photons, eye paths and path tracer alike.
inline constexpr float kFollowedRoughness = 0.3f;

/// Rough glass of exactly the index of its surroundings would be no surface at all.
inline constexpr float kLeastRoughIndex = 1.001f;

inline bool is_followed(float roughness)
{
    return roughness <= kFollowedRoughness;
}

/// Width of facets; 0: a mirror.
inline float alpha_of(float roughness)
{
    return roughness > kMirrorRoughness ? roughness * roughness : 0;
}

/// What becomes of the reflection of an opaque surface.
enum class Reflection : std::uint8_t {
    none,
    mirror,   ///< one direction
    followed, ///< spread over facets, followed in a direction drawn
    gathered, ///< spread over facets, photons are stored
};

/// Of a reflection that is there.
inline Reflection kind_of(float roughness)
{
    if (alpha_of(roughness) == 0)
        return Reflection::mirror;
    return is_followed(roughness) ? Reflection::followed : Reflection::gathered;
}

/// Cosines of a direction: to the shading normal, and to that of the clear coat, which may be
/// another.
struct Incidence {
    float cosine, coat;

    Incidence(float to_both) : cosine(to_both), coat(to_both) {} // NOLINT: mostly there is one
    Incidence(float to_surface, float to_coat) : cosine(to_surface), coat(to_coat) {}
};

/// A material, ready for shading.  docs/light_transport.md (1)-(4).
/// The base (diffuse) lobe is separable: f(wi, wo) = diffuse / pi * coat_half(wi) * coat_half(wo).
struct Bsdf {
    Rgb diffuse{0.0f};         ///< the factor above, albedo where there is no coat
    Rgb diffuse_beyond{0.0f};  ///< the same of light that comes out on the other side
    bool only_diffuse = false; ///< there is no more to it than that lobe
    bool coated = false;       ///< a dielectric lies over the diffuse lobe
    Reflection reflection = Reflection::none;
    float alpha = 0.0f;       ///< width of the facets' distribution; 0: mirror, clear glass
    float alpha_along = 0.0f; ///< of stretched ones along `along`, else 0
    glm::vec3 along{0.0f};    ///< unit, across the shading normal
    ReflectionModel model = ReflectionModel::metallic_roughness; ///< of the reflection
    float exponent = 0.0f;                                       ///< of Phong's lobe
    float isotropy = 1.0f;     ///< of Schlick's; below 1: stretched along `along`
    float mirror_share = 0.0f; ///< of Schlick's: what a mirror reflects beside what is spread
    Rgb coat_f0{0.0f};         ///< reflectance of the coat at normal and ...
    Rgb coat_f90{0.0f};        ///< ... grazing incidence
    Rgb coat_average{0.0f};    ///< its albedo averaged over the cosine-weighted hemisphere
    Rgb reflect_f0{0.0f};      ///< the same two of metal and coat together, by their shares
    Rgb reflect_f90{0.0f};
    Rgb regained{0.0f}; ///< factor of the lobe that facets of metal pass to one another
    Reflection clearcoat = Reflection::none; ///< what becomes of the reflection of a coat over all
    float clearcoat_share = 0.0f;
    float clearcoat_alpha = 0.0f;
    glm::vec3 coat_normal{0.0f}; ///< shading normal of the clear coat, where it has one of its own
    float coat_agreement = 1.0f; ///< its cosine with that of what is below; 1: it has none
    Rgb sheen{0.0f};             ///< colour of fibres that stand on all but the clear coat
    float sheen_alpha = 1.0f;
    float glass = 0.0f;         ///< share that is a dielectric that transmits
    Rgb glass_tint{1.0f};       ///< transmitted at each crossing
    Rgb glass_reflection{1.0f}; ///< scale of its Fresnel reflection (KHR_materials_specular)
    float ior = 1.5f;
    float dispersion = 0.0f;     ///< 20 / Abbe number of that glass; 0: colours go the same way
    float burley_roughness = -1; ///< of the diffuse lobe; below zero: Lambert
    Rgb absorption{0.0f};        ///< inside, per scene unit
    Rgb emission{0.0f};          ///< radiance, W/(m2 sr)
    bool emits_behind = false;

    /// The diffuse lobe is all, which may be black: coats and reflections are not looked at.
    bool is_matt() const { return kMattOnly || only_diffuse; }
    bool has_diffuse() const { return !is_black(diffuse); }
    bool has_sheen() const { return !is_matt() && !is_black(sheen); }
    /// Light comes through scattered, docs/light_transport.md (32).
    bool passes_diffusely() const { return !is_matt() && !is_black(diffuse_beyond); }
    /// Facets are wider along one direction than across it.
    bool is_stretched() const { return !kMattOnly && alpha_along > 0; }
    /// The reflection is Phong's or Schlick's (reflection_models.h).
    bool is_modelled() const { return !kMattOnly && model != ReflectionModel::metallic_roughness; }
    /// `along` has to be known.
    bool is_directed() const { return is_stretched() || (!kMattOnly && isotropy < 1); }
    /// Light that facets pass to one another is added to their reflection.
    bool is_compensated() const { return !kMattOnly && !is_black(regained); }
    /// Some reflection becomes what is asked for.
    bool reflects(Reflection kind) const { return reflection == kind || clearcoat == kind; }
    /// Some light is reflected in one direction alone.
    bool has_mirror() const { return reflects(Reflection::mirror) || mirror_share > 0; }
    /// Photons are stored here: there is a diffuse lobe, sheen or a reflection that is gathered.
    bool gathers() const
    {
        return has_diffuse() || has_sheen() || passes_diffusely() ||
               (!is_matt() && reflects(Reflection::gathered));
    }
    /// A direction is to be drawn to follow the path: there is a followed reflection or rough
    /// glass.
    bool follows() const
    {
        return !is_matt() && (reflects(Reflection::followed) || (glass > 0 && alpha > 0));
    }
};

/// direction: unit, away from the surface.  cosine: its own to the shading normal.
inline Incidence incidence(const Bsdf& bsdf, const glm::vec3& direction, float cosine)
{
    return bsdf.coat_agreement < 1 ? Incidence(cosine, glm::dot(direction, bsdf.coat_normal))
                                   : Incidence(cosine);
}

/// The material at a point.
Bsdf make_bsdf(const Material& material, const MaterialPoint& at, DiffuseModel model);

/// One for each material of the scene, by its factors alone.
std::vector<Bsdf> make_bsdfs(const std::vector<Material>& materials, DiffuseModel model);

/// The factor of Burley's lobe, docs/light_transport.md (13).
float burley_shape(const Bsdf& bsdf, const glm::vec3& normal, const glm::vec3& wi,
                   const glm::vec3& wo);

/// What the diffuse lobe is multiplied by for a pair of directions; 1 for Lambert.  normal:
/// shading; all unit, the directions away from the surface.
inline float diffuse_shape(const Bsdf& bsdf, const glm::vec3& normal, const glm::vec3& wi,
                           const glm::vec3& wo)
{
    return bsdf.burley_roughness < 0 ? 1.0f : burley_shape(bsdf, normal, wi, wo);
}

/// The clear coat as a material of its own; there must be one.
Bsdf clearcoat_alone(const Bsdf& bsdf);

/// The part of light along one direction that the clear coat reflects; 0 without one.  cosine: to
/// the coat's normal.
float clearcoat_albedo(const Bsdf& bsdf, float cosine);

/// What of light that is reflected below the clear coat gets through it both times.  1 without one.
/// docs/light_transport.md (24).
float through_clearcoat(const Bsdf& bsdf, const Incidence& in, const Incidence& out);

/// What of light along one direction gets past the fibres of a sheen; 1 without one.
float past_sheen(const Bsdf& bsdf, float cosine);

/// What of light that is reflected below the clear coat and the fibres gets through them both
/// times.  docs/light_transport.md (24), (28).
float through_layers(const Bsdf& bsdf, const Incidence& in, const Incidence& out);

/// Share of light along one direction that the fibres scatter, clear coat apart.
Rgb sheen_share(const Bsdf& bsdf, float cosine);

/// What gets through the coats that there may be, and past fibres.
Rgb through_coats(const Bsdf& bsdf, const Incidence& along);

/// What of the light from (or to) a direction gets through the coats; 1 without any.
/// cosine: of the angle to the shading normal, [0, 1].
inline Rgb coat_half(const Bsdf& bsdf, float cosine)
{
    return bsdf.is_matt() ? Rgb(1) : through_coats(bsdf, cosine);
}

/// The part of light along one direction that the diffuse lobe scatters over the whole hemisphere:
/// the integral of f(wi, wo) cos(wo) over wo.
inline Rgb diffuse_albedo(const Bsdf& bsdf, const Incidence& along)
{
    return bsdf.is_matt() ? bsdf.diffuse
                          : bsdf.diffuse * through_coats(bsdf, along) * (1.0f - bsdf.coat_average);
}

/// The same that comes out on the other side.
inline Rgb passed_albedo(const Bsdf& bsdf, const Incidence& along)
{
    return bsdf.passes_diffusely()
               ? bsdf.diffuse_beyond * through_coats(bsdf, along) * (1.0f - bsdf.coat_average)
               : Rgb(0);
}

/// Reflectance of a smooth interface between dielectrics for unpolarised light; 1 at total
/// reflection. cosine: of incidence, [0, 1].  eta: index beyond the interface over index before it.
float fresnel_dielectric(float cosine, float eta);

/// Reflectance of a facet of an opaque surface, metal and coat together (Schlick).  cosine: of
/// incidence on the facet.
Rgb opaque_reflectance(const Bsdf& bsdf, float cosine);

/// The part of light along one direction that the opaque surface reflects, diffuse lobe apart, with
/// what facets pass to one another.  Zero without a reflection.
Rgb reflection_albedo(const Bsdf& bsdf, float cosine);

/// Index beyond the surface over index before it.
/// front: the light (or eye) is in front of the face.  solid: the face belongs to a closed surface;
/// otherwise it is a thin wall, of which this is the index of the wall itself.
float index_beyond(const Bsdf& bsdf, bool front, bool solid);

/// Reflectance of a facet of glass, scaled by KHR_materials_specular unless reflection is total.
Rgb glass_reflectance(const Bsdf& bsdf, float cosine, float eta);

/// The mirror and clear glass lobes for one direction, as shares of its light.
struct SpecularLobes {
    Rgb mirror{0.0f};
    Rgb transmit{0.0f};
    float eta = 1.0f; ///< index beyond the interface over index before it; 1 through a thin wall
};

/// The same of a surface that is not matt.
SpecularLobes smooth_lobes(const Bsdf& bsdf, const Incidence& along, bool front, bool solid);

/// front, solid: as above; a thin wall is crossed straight.  Zero where the
/// lobes are spread over facets.
inline SpecularLobes specular_lobes(const Bsdf& bsdf, const Incidence& along, bool front,
                                    bool solid)
{
    return bsdf.is_matt() ? SpecularLobes{} : smooth_lobes(bsdf, along, front, solid);
}

/// The direction beyond a smooth interface; away from the surface on the other side.
/// direction: unit, away from the surface on the side the light comes from; normal: unit, same
/// side. eta: as above; there must be no total reflection.
glm::vec3 refract(const glm::vec3& direction, const glm::vec3& normal, float eta);

/// Mirror image of `direction` in the plane across `normal`: on its other side.
inline glm::vec3 mirrored(const glm::vec3& direction, const glm::vec3& normal)
{
    return direction - 2 * glm::dot(direction, normal) * normal;
}

/// Mirror image of `direction` about `normal`; both unit and away from the surface.
glm::vec3 reflect(const glm::vec3& direction, const glm::vec3& normal);

} // namespace hipmap
