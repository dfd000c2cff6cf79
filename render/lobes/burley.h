#pragma once

#include "common/math/frame.h"
#include "common/math/sampling.h"
#include "render/lobes/fresnel.h"
#include "render/lobes/lobe_view.h"

namespace hipmap {

/// Diffuse reflection by Burley's model, docs/light_transport.md (13).
struct Burley {
    static constexpr bool kFolds = false, kSeparable = false;
    Rgb reflectance{0.0f};
    float roughness = 0.5f;

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
    /// Returns the reflectance without the shape, whose average over `in` is near 1.
    Rgb albedo(const LobeView&) const { return reflectance; }

    /// Returns the factor over Lambert's law for a pair of directions.
    float shape(const LobeView& view, const glm::vec3& in) const
    {
        const float cos2_half = 0.5f * (1 + glm::dot(in, view.out)); // of half the angle between
        const float grazing = 2 * roughness * cos2_half - 0.5f;
        return (1 + grazing * grazing_weight(glm::dot(in, view.normal))) *
               (1 + grazing * grazing_weight(view.cosine));
    }
};

} // namespace hipmap
