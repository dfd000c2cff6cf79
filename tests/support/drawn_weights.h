#pragma once

#include "tests/support/lit_surface.h"
#include "tests/support/statistics.h"

namespace hipmap::tiny {

/// What the lobes send on of light from at.back, in the second channel: by quadrature, and by the
/// weights of directions drawn.
struct IntegralAndWeights {
    double integral = 0;
    RunningMean weights;
};

inline IntegralAndWeights integral_and_weights(const Interaction& at, Lobes lobes)
{
    IntegralAndWeights out;
    over_sphere(250, [&](const glm::vec3& in, double solid_angle) {
        out.integral += double{scattered(at, in, lobes).value.y} * solid_angle;
    });
    for (std::uint64_t i = 0; i < 20000; ++i) {
        RandomSequence random(5, RandomStream::pictures, 0, i);
        out.weights.add(sample_scatter(at, lobes, random).weight.y);
    }
    return out;
}

} // namespace hipmap::tiny
