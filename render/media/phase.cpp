#include "render/media/phase.h"

#include "common/math/frame.h"
#include "common/math/sampling.h"

#include <algorithm>
#include <cmath>

namespace hipmap {

namespace {

/// Schlick's parameter for a Henyey and Greenstein function, docs/media.md (2).
float schlick_k(float g)
{
    return g * (1.55f - 0.55f * g * g);
}

/// a: 2u - 1.  None of them divides by g, which may be as small as it likes.
float drawn_cosine(const PhaseFunction& phase, float a)
{
    const float g = phase.g;
    switch (phase.kind) {
    case PhaseKind::isotropic:
        return a;
    case PhaseKind::henyey_greenstein:
        return (a + g * (0.5f * (a * a + 3) + g * (a + 0.5f * g * (a * a - 1)))) /
               ((1 + g * a) * (1 + g * a));
    case PhaseKind::schlick:
        return (a + schlick_k(g)) / (1 + schlick_k(g) * a);
    }
    return a;
}

} // namespace

float phase_value(const PhaseFunction& phase, float cosine)
{
    constexpr float kEven = 1 / (4 * kPi);
    switch (phase.kind) {
    case PhaseKind::isotropic:
        return kEven;
    case PhaseKind::henyey_greenstein: {
        const float g = phase.g;
        // The same as 1 + g^2 - 2 g c, without cancellation where that is small.
        const float squared = (1 - g) * (1 - g) + 2 * g * (1 - cosine);
        return kEven * (1 - g * g) / (squared * std::sqrt(squared));
    }
    case PhaseKind::schlick: {
        const float k = schlick_k(phase.g);
        const float below = 1 - k * cosine;
        return kEven * (1 - k * k) / (below * below);
    }
    }
    return kEven;
}

glm::vec3 sample_phase(const PhaseFunction& phase, const glm::vec3& travel, const glm::vec2& u)
{
    const float cosine = std::clamp(drawn_cosine(phase, 2 * u.x - 1), -1.0f, 1.0f);
    return Frame(travel).to_world(direction_from_cosine(cosine, u.y));
}

} // namespace hipmap
