#include "render/lights/spot_cone.h"

#include "common/math/frame.h"
#include "common/math/sampling.h"

#include <algorithm>
#include <cmath>

namespace hipmap {

float falloff(const SpotCone& cone, const glm::vec3& direction)
{
    const float cosine = glm::dot(direction, cone.direction);
    const float t =
        std::clamp((cosine - cone.cos_outer) / (cone.cos_inner - cone.cos_outer), 0.0f, 1.0f);
    return t * t;
}

float falloff_integral(const SpotCone& cone)
{
    return 2 * kPi * ((1 - cone.cos_inner) + (cone.cos_inner - cone.cos_outer) / 3);
}

glm::vec3 sample_direction(const SpotCone& cone, RandomSequence& random)
{
    // Inner cone and rim are picked by their power; within the rim the pdf follows the fall-off.
    const float inner = 1 - cone.cos_inner;
    const float rim = (cone.cos_inner - cone.cos_outer) / 3;
    const float u = random.next() * (inner + rim);
    float cosine;
    if (u < inner) {
        cosine = 1 - u;
    } else {
        const float t = std::cbrt((u - inner) / rim);
        cosine = cone.cos_outer + t * (cone.cos_inner - cone.cos_outer);
    }
    return Frame(cone.direction)
        .to_world(direction_from_cosine(std::min(cosine, 1.0f), random.next()));
}

} // namespace hipmap
