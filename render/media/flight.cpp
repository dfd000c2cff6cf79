#include "render/media/flight.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>

namespace hipmap {

namespace {

/// The channel that the distance is drawn by.
int pick_channel(const Rgb& chances, float u)
{
    if (u < chances.x)
        return 0;
    return u < chances.x + chances.y || chances.z == 0 ? 1 : 2;
}

float draw_distance(float extinction, float u)
{
    return extinction > 0 ? -std::log1p(-u) / extinction : std::numeric_limits<float>::infinity();
}

} // namespace

Rgb transmitted(const Rgb& extinction, float column)
{
    Rgb out;
    for (int c = 0; c < 3; ++c)
        out[c] = extinction[c] > 0 ? std::exp(-extinction[c] * column) : 1.0f;
    return out;
}

Rgb emitted_along(const Medium& medium, float column)
{
    const Rgb extinction = medium.extinction();
    Rgb out;
    for (int c = 0; c < 3; ++c)
        out[c] =
            medium.emission[c] *
            (extinction[c] > 0 ? -std::expm1(-extinction[c] * column) / extinction[c] : column);
    return out;
}

Flight sample_flight(const Medium& medium, float limit, const Rgb& carried, RandomSequence& random)
{
    const Rgb extinction = medium.extinction();
    Flight out{false, limit, transmitted(extinction, limit)};
    const float sum = carried.x + carried.y + carried.z;
    if (!medium.scatters() || !(sum > 0))
        return out;
    const Rgb chances = carried / sum;
    const int channel = pick_channel(chances, random.next());
    const float column = draw_distance(extinction[channel], random.next());
    out.scattered = column < limit;
    if (out.scattered) {
        out.column = column;
        const Rgb left = transmitted(extinction, column);
        const float density = glm::dot(chances, extinction * left);
        out.weight = density > 0 ? medium.scattering * left / density : Rgb(0);
        return out;
    }
    const float chance = glm::dot(chances, out.weight);
    out.weight = chance > 0 ? out.weight / chance : Rgb(0);
    return out;
}

} // namespace hipmap
