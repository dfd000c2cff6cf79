#pragma once

#include "render/lobes/fresnel.h"
#include "render/lobes/shaped_diffuse.h"

namespace hipmap {

/// Burley's factor over Lambert's law, docs/light_transport.md (13).
struct BurleyShape {
    float roughness = 0.5f; ///< 0 to 1

    float operator()(const LobeView& view, const glm::vec3& in) const
    {
        const float cos2_half = 0.5f * (1 + glm::dot(in, view.out)); // of half the angle between
        const float grazing = 2 * roughness * cos2_half - 0.5f;
        return (1 + grazing * grazing_weight(glm::dot(in, view.normal))) *
               (1 + grazing * grazing_weight(view.cosine));
    }
};

/// Diffuse reflection by Burley's model.
using Burley = ShapedDiffuse<BurleyShape>;

} // namespace hipmap
