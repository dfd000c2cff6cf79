#pragma once

#include "common/math/frame.h"
#include "common/math/sampling.h"
#include "render/lobes/lobe_view.h"

namespace hipmap {

/// Diffuse reflection by Lambert's law, docs/light_transport.md (1).
struct Lambert {
    static constexpr bool kFolds = false, kSeparable = true;
    Rgb reflectance{0.0f};

    Rgb eval(const LobeView&, const glm::vec3&) const { return reflectance / kPi; }
    float pdf(const LobeView& view, const glm::vec3& in) const
    {
        return glm::dot(view.normal, in) / kPi;
    }
    LobeSample sample(const LobeView& view, RandomSequence& random) const
    {
        return {Frame(view.normal).to_world(sample_cosine_hemisphere(random.next2())), reflectance};
    }
    Rgb albedo(const LobeView&) const { return reflectance; }
};

} // namespace hipmap
