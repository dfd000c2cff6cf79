#pragma once

#include "render/shading/interaction.h"

namespace hipmap {

/// Returns the cosines of a direction on either side, with absolute values for the transmitted
/// side.
inline Incidence incidence_on_side(const Interaction& at, const glm::vec3& in)
{
    const float cosine = glm::dot(in, at.shading_normal);
    return cosine < 0 ? incidence(at, -in, -cosine) : incidence(at, in, cosine);
}

/// Returns f |cos| of a lobe for light from `in`, attenuated by the layers above it on the way in
/// alone, and without folded light.  The cosine is to the lobe's own normal.  in: on the side from
/// which the lobe takes light, by that normal.
inline Rgb value_of(const Interaction& at, const PlacedLobe& lobe, const LobeView& view,
                    const glm::vec3& in)
{
    const Rgb value = eval(lobe.lobe, view, in) * std::abs(glm::dot(in, view.normal));
    const Layers& layers = at.bsdf().layers;
    return layers.any ? value * transmitted_by(layers, lobe.depth, incidence_on_side(at, in))
                      : value;
}

/// Returns about the share of light from `back` that a lobe scatters, attenuated by the layers
/// above it.
inline Rgb albedo_of(const Interaction& at, const PlacedLobe& lobe)
{
    const Rgb alone = albedo(lobe.lobe, view_of(at, lobe.depth));
    const Layers& layers = at.bsdf().layers;
    return layers.any ? alone * transmitted_twice(layers, lobe.depth, at.seen()) : alone;
}

} // namespace hipmap
