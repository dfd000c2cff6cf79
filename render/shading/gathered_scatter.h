#pragma once

#include "common/math/frame.h"
#include "common/math/sampling.h"
#include "render/shading/gathered_lobes.h"
#include "render/shading/scatter.h"

namespace hipmap {

// The gathered lobes of a surface below its clear coat.

/// As `scattered` has it, of a surface that gathers and is not matt.
Scattered scattered_by_gathered(const Interaction& at, const glm::vec3& in);

/// Draws a direction from them, by the albedo of each.
ScatterSample sample_gathered(const Interaction& at, RandomSequence& random);

/// The shading normal sent the direction drawn past the face, or, of light that passes, not past
/// it.
inline bool is_astray(const Interaction& at, const ScatterSample& sample)
{
    return !((sample.transmitted ? -1.0f : 1.0f) * glm::dot(sample.direction, at.normal) > 0);
}

/// Adds the diffuse lobe, of which `chance` is drawn.  in: above the face.
inline void add_diffuse(const Interaction& at, const glm::vec3& in, float chance, Scattered& out)
{
    const float cosine = glm::dot(in, at.shading_normal);
    if (!(cosine > 0))
        return;
    const GatheredLobes lobes(at.bsdf, at.shading_normal, at.normal, at.back);
    out.value += lobes.diffuse(in, cosine) * cosine;
    out.density += chance * cosine / kPi;
}

inline glm::vec3 sample_diffuse(const Interaction& at, RandomSequence& random)
{
    return Frame(at.shading_normal).to_world(sample_cosine_hemisphere(random.next2()));
}

} // namespace hipmap
