#pragma once

#include "render/lobes/shaped_diffuse.h"

#include <algorithm>

namespace hipmap {

/// Oren and Nayar's factor over Lambert's law in Fujii's form, docs/light_transport.md (37).
struct OrenNayarShape {
    float roughness = 0.5f; ///< 0 (Lambert's law) to 1

    float operator()(const LobeView& view, const glm::vec3& in) const
    {
        const float cosine = glm::dot(view.normal, in);
        const float s = glm::dot(in, view.out) - cosine * view.cosine;
        const float t = s > 0 ? std::max(cosine, view.cosine) : 1.0f;
        return (1 + roughness * s / t) / (1 + (0.5f - 2 / (3 * kPi)) * roughness);
    }
};

/// Diffuse reflection of rough plaster, clay or stone.
using OrenNayar = ShapedDiffuse<OrenNayarShape>;

} // namespace hipmap
