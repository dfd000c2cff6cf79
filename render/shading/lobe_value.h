#pragma once

#include "render/shading/interaction.h"

namespace hipmap {

/// Cosines of a direction on either side; those on the other side count as if on this one.
inline Incidence incidence_on_side(const Interaction& at, const glm::vec3& in)
{
    const float cosine = glm::dot(in, at.shading_normal);
    return cosine < 0 ? incidence(at, -in, -cosine) : incidence(at, in, cosine);
}

/// f |cos| of a lobe for light from `in`, through the layers above it on the way in alone, and
/// without what is folded.  The cosine is to the lobe's own normal.  in: on the side from which the
/// lobe takes light, by that normal.
inline Rgb value_of(const Interaction& at, const PlacedLobe& lobe, const LobeView& view,
                    const glm::vec3& in)
{
    const Rgb value = eval(lobe.lobe, view, in) * std::abs(glm::dot(in, view.normal));
    const Layers& layers = at.bsdf().layers;
    return layers.any ? value * transmitted_by(layers, lobe.depth, incidence_on_side(at, in))
                      : value;
}

/// About the share of light from `back` that a lobe scatters, through the layers above it.
inline Rgb albedo_of(const Interaction& at, const PlacedLobe& lobe)
{
    const Rgb alone = albedo(lobe.lobe, view_of(at, lobe.depth));
    const Layers& layers = at.bsdf().layers;
    return layers.any ? alone * transmitted_twice(layers, lobe.depth, at.seen()) : alone;
}

} // namespace hipmap
