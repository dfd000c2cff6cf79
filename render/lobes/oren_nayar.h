#pragma once

#include "common/math/frame.h"
#include "common/math/sampling.h"
#include "render/lobes/lobe_view.h"

#include <algorithm>

namespace hipmap {

/// Diffuse reflection of rough plaster, clay or stone by Oren and Nayar's model in Fujii's form,
/// docs/light_transport.md (37).
struct OrenNayar {
    static constexpr bool kFolds = false, kSeparable = false;
    Rgb reflectance{0.0f};
    float roughness = 0.5f; ///< 0 (Lambert's law) to 1

    Rgb eval(const LobeView& view, const glm::vec3& in) const
    {
        return reflectance * (shape(view, in) / kPi);
    }
    float pdf(const LobeView& view, const glm::vec3& in) const
    {
        return glm::dot(view.normal, in) / kPi;
    }
    LobeSample sample(const LobeView& view, RandomSequence& random) const
    {
        const glm::vec3 in = Frame(view.normal).to_world(sample_cosine_hemisphere(random.next2()));
        return {in, reflectance * shape(view, in)};
    }
    /// Without the shape, whose average over `in` is between 0.7 and 1.
    Rgb albedo(const LobeView&) const { return reflectance; }

    /// Factor over Lambert's law for a pair of directions, 0 or more.
    float shape(const LobeView& view, const glm::vec3& in) const
    {
        const float cosine = glm::dot(view.normal, in);
        const float s = glm::dot(in, view.out) - cosine * view.cosine;
        const float t = s > 0 ? std::max(cosine, view.cosine) : 1.0f;
        return (1 + roughness * s / t) / (1 + (0.5f - 2 / (3 * kPi)) * roughness);
    }
};

} // namespace hipmap
