#include "render/media/free_path.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>

namespace hipmap {

namespace {

/// The channel that the distance is drawn by.
int pick_channel(const Rgb& probabilities, float u)
{
    if (u < probabilities.x)
        return 0;
    return u < probabilities.x + probabilities.y || probabilities.z == 0 ? 1 : 2;
}

float draw_distance(float extinction, float u)
{
    return extinction > 0 ? -std::log1p(-u) / extinction : std::numeric_limits<float>::infinity();
}

} // namespace

Rgb transmitted(const Rgb& extinction, float optical_depth)
{
    Rgb out;
    for (int c = 0; c < 3; ++c)
        out[c] = extinction[c] > 0 ? std::exp(-extinction[c] * optical_depth) : 1.0f;
    return out;
}

Rgb emitted_along(const Medium& medium, float optical_depth)
{
    const Rgb extinction = medium.extinction();
    Rgb out;
    for (int c = 0; c < 3; ++c)
        out[c] = medium.emission[c] *
                 (extinction[c] > 0 ? -std::expm1(-extinction[c] * optical_depth) / extinction[c]
                                    : optical_depth);
    return out;
}

FreePath sample_free_path(const Medium& medium, float limit, const Rgb& carried,
                          RandomSequence& random)
{
    const Rgb extinction = medium.extinction();
    FreePath out{false, limit, transmitted(extinction, limit)};
    const float sum = sum_of_channels(carried);
    if (!medium.scatters() || !(sum > 0))
        return out;
    const Rgb probabilities = carried / sum;
    const int channel = pick_channel(probabilities, random.next());
    const float optical_depth = draw_distance(extinction[channel], random.next());
    out.scattered = optical_depth < limit;
    if (out.scattered) {
        out.optical_depth = optical_depth;
        const Rgb left = transmitted(extinction, optical_depth);
        const float pdf = glm::dot(probabilities, extinction * left);
        out.weight = pdf > 0 ? medium.scattering * left / pdf : Rgb(0);
        return out;
    }
    const float probability = glm::dot(probabilities, out.weight);
    out.weight = probability > 0 ? out.weight / probability : Rgb(0);
    return out;
}

} // namespace hipmap
