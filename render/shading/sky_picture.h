#pragma once

#include "common/image/image.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace hipmap {

/// A picture of the whole sky, by longitude and latitude, ready to be looked at and drawn from.
/// Each pixel is of one radiance all over, docs/light_transport.md (27).
struct SkyPicture {
    Image radiance;           ///< W/(m2 sr); empty: there is none
    float turn = 0.0f;        ///< radians that it is turned about +y, counter-clockwise from above
    std::vector<double> rows; ///< [H] running sum of the chances of rows, ends at 1
    std::vector<float> columns; ///< [H * W] running sums within each row, which end at 1
    double flux = 0.0;          ///< integral of the largest channel over directions, W/m2

    bool empty() const { return radiance.pixels.empty(); }
};

/// strength: multiplies the picture.  Radiance is finite and not below zero.  A picture that is
/// black all over, or without pixels, becomes an empty one.  O(pixels).
SkyPicture make_sky_picture(const Image& picture, float strength, float turn);

/// Of the pixels and the turn.
std::uint64_t checksum(const SkyPicture& sky);

/// Radiance from a direction (unit, away from the scene).  The picture is not empty.
Rgb sky_radiance(const SkyPicture& sky, const glm::vec3& direction);

/// Chance per solid angle that `sample_sky` draws the direction.
float sky_density(const SkyPicture& sky, const glm::vec3& direction);

/// Draws a direction in proportion to the largest channel of its radiance.
glm::vec3 sample_sky(const SkyPicture& sky, const glm::vec2& u);

} // namespace hipmap
