#pragma once

#include "render/lobes/fresnel.h"

namespace hipmap {

/// Cosines of a direction to the shading normal, and to the normal of the clear coat, which may
/// differ.
struct Incidence {
    float cosine, coat;

    Incidence(float to_both) : cosine(to_both), coat(to_both) {} // NOLINT: mostly there is one
    Incidence(float to_surface, float to_coat) : cosine(to_surface), coat(to_coat) {}
};

/// The depth of a lobe, from the top; each layer above attenuates its light.
enum class Depth : std::uint8_t { clearcoat, sheen, reflection, diffuse };

/// Layers that attenuate the light of lobes below them, docs/light_transport.md (2), (24), (28).
struct Layers {
    Reflectance coat;             ///< of the dielectric over the diffuse lobe
    float coat_alpha = 0.0f;      ///< GGX width of that coat; 0: smooth
    float sheen = 0.0f;           ///< largest channel of the colour of fibres; 0: none
    float sheen_alpha = 1.0f;     ///< their width
    float clearcoat = 0.0f;       ///< share of the surface under a clear coat (index 1.5); 0: none
    float clearcoat_alpha = 0.0f; ///< its GGX width; 0: smooth
    bool coated = false;          ///< there is a dielectric over the diffuse lobe
    bool adds = false;            ///< layers add their light to that of lobes below, which they do
                                  ///<   not attenuate, docs/light_transport.md (38)
    bool any = false;             ///< there is some layer that attenuates
    Rgb diffuse_average{1.0f};    ///< what reaches the diffuse lobe, averaged over the
                                  ///<   cosine-weighted hemisphere
};

/// Returns the reflectance of a clear coat at normal and at grazing incidence.
inline constexpr Reflectance clearcoat_fresnel(float share)
{
    return {Rgb(share * 0.04f), Rgb(share)};
}

/// Returns the share of light along a direction that passes the layers above a depth; equal into
/// the surface and out of it.
Rgb transmitted_by(const Layers& layers, Depth depth, const Incidence& along);

/// Returns the share of light along a direction that layers leave on its way to a lobe and back out
/// in any direction, averaged over those: the factor of the lobe's albedo.
inline Rgb transmitted_twice(const Layers& layers, Depth depth, const Incidence& along)
{
    if (!layers.any)
        return Rgb(1);
    const Rgb once = transmitted_by(layers, depth, along);
    return depth == Depth::diffuse ? once * layers.diffuse_average : once;
}

/// Returns the albedo of a reflection of any width (0: smooth) and its cosine-weighted average.
Rgb reflection_albedo(const Reflectance& fresnel, float cosine, float alpha);
Rgb average_reflection_albedo(const Reflectance& fresnel, float alpha);

/// Sets `any` and `diffuse_average` once all layers are there.
void finish(Layers& layers);

} // namespace hipmap
