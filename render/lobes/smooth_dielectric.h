#pragma once

#include "render/lobes/fresnel.h"
#include "render/lobes/lobe_view.h"

namespace hipmap {

/// Clear glass: reflects and transmits in one direction each, docs/light_transport.md (4).
struct SmoothDielectric {
    float share = 1.0f;   ///< of the surface that is this dielectric
    Rgb tint{1.0f};       ///< transmitted at each crossing
    Rgb reflection{1.0f}; ///< scale of the Fresnel reflection (KHR_materials_specular)

    SpecularLobes specular(const LobeView& view) const
    {
        const Rgb reflected = scaled_fresnel(view.cosine, view.eta, reflection);
        return {share * reflected, share * (1.0f - reflected) * tint, view.solid ? view.eta : 1.0f};
    }
};

} // namespace hipmap
