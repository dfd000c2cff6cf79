#pragma once

#include "common/math/frame.h"
#include "common/math/sampling.h"
#include "render/lobes/lobe_view.h"

namespace hipmap {

/// Light that a thin surface scatters evenly to its transmitted side
/// (KHR_materials_diffuse_transmission), docs/light_transport.md (32).
struct DiffuseTransmission {
    static constexpr bool kFolds = false, kSeparable = true, kTransmits = true;
    Rgb transmittance{0.0f};

    Rgb eval(const LobeView& view, const glm::vec3& in) const
    {
        return glm::dot(view.normal, in) < 0 ? transmittance / kPi : Rgb(0);
    }
    float pdf(const LobeView& view, const glm::vec3& in) const
    {
        return std::max(0.0f, -glm::dot(view.normal, in)) / kPi;
    }
    LobeSample sample(const LobeView& view, RandomSequence& random) const
    {
        const glm::vec3 in = Frame(-view.normal).to_world(sample_cosine_hemisphere(random.next2()));
        return {in, transmittance, 1.0f, true};
    }
    Rgb albedo(const LobeView&) const { return transmittance; }
};

} // namespace hipmap
