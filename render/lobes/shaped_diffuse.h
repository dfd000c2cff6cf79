#pragma once

#include "common/math/frame.h"
#include "common/math/sampling.h"
#include "render/lobes/lobe_view.h"

namespace hipmap {

/// Diffuse reflection whose f is Lambert's times a factor of both directions.
/// Shape: called with (view, in), returns that factor, 0 or more; its average over `in` is near 1.
template <typename Shape>
struct ShapedDiffuse {
    static constexpr bool kFolds = false, kSeparable = false;
    Rgb reflectance{0.0f};
    Shape shape;

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
    /// Returns the reflectance without the shape.
    Rgb albedo(const LobeView&) const { return reflectance; }
};

} // namespace hipmap
