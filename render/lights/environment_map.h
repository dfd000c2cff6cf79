#pragma once

#include "common/image/image.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace hipmap {

/// An environment map by longitude and latitude, with tables for drawing directions. Each pixel has
/// constant radiance, docs/light_transport.md (27).
struct EnvironmentMap {
    Image radiance;           ///< W/(m2 sr); empty: there is none
    float turn = 0.0f;        ///< radians that it is turned about +y, counter-clockwise from above
    std::vector<double> rows; ///< [H] running sum of the probabilities of rows, ends at 1
    std::vector<float> columns;  ///< [H * W] running sums within each row, which end at 1
    double brightest_flux = 0.0; ///< integral of the largest channel over directions, W/m2
    glm::dvec3 flux{0.0};        ///< integral of each channel over directions, W/m2

    bool empty() const { return radiance.pixels.empty(); }
};

/// Builds an environment map.  strength: multiplies the image.  Radiance must be finite and not
/// below zero.  An image that is black all over, or without pixels, becomes an empty map.
/// O(pixels).
EnvironmentMap make_environment_map(const Image& image, float strength, float turn);

/// Returns a checksum of the pixels and the turn.
std::uint64_t checksum(const EnvironmentMap& map);

/// The radiance and the pdf of a map in a direction.
struct MapPoint {
    Rgb radiance{0.0f}; ///< W/(m2 sr)
    float pdf = 0.0f;   ///< per solid angle, that `sample_direction` draws the direction
};

/// Looks up a direction.  direction: unit, away from the scene.  The map must not be empty.
MapPoint at_direction(const EnvironmentMap& map, const glm::vec3& direction);

/// Draws a direction with a pdf in proportion to the largest channel of its radiance.  The map must
/// not be empty.  u: [0, 1)^2.
glm::vec3 sample_direction(const EnvironmentMap& map, const glm::vec2& u);

/// Returns the u from which `sample_direction` makes a unit direction.  The map must not be empty.
glm::vec2 direction_sample_of(const EnvironmentMap& map, const glm::vec3& direction);

} // namespace hipmap
