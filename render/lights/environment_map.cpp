#include "render/lights/environment_map.h"

#include "common/math/random.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace hipmap {

namespace {

using std::numbers::pi;

/// Returns the cosine of the upper edge of a row, counted from the top.
double edge_cosine(const EnvironmentMap& map, int row)
{
    return std::cos(pi * row / map.radiance.height);
}

/// Returns the solid angle of each pixel of a row.
double solid_angle(const EnvironmentMap& map, int row)
{
    return 2 * pi / map.radiance.width * (edge_cosine(map, row) - edge_cosine(map, row + 1));
}

struct Pixel {
    int x, y;
};

/// Returns the place of a unit direction in the map, in pixels.
glm::dvec2 place_towards(const EnvironmentMap& map, const glm::vec3& direction)
{
    const int width = map.radiance.width, height = map.radiance.height;
    const double turned =
        0.5 + (std::atan2(double{direction.z}, double{direction.x}) + map.turn) / (2 * pi);
    const double u = turned - std::floor(turned);
    const double v = std::acos(std::clamp(double{direction.y}, -1.0, 1.0)) / pi;
    return {u * width, v * height};
}

/// Returns the pixel at a place in the map.
Pixel pixel_at(const EnvironmentMap& map, const glm::dvec2& at)
{
    return {std::min(static_cast<int>(at.x), map.radiance.width - 1),
            std::min(static_cast<int>(at.y), map.radiance.height - 1)};
}

/// Draws from running sums that end at 1; u becomes the place within what was drawn, [0, 1).
template <typename Sum>
int draw(const Sum* sums, int count, double& u)
{
    const Sum* const last = sums + count - 1;
    const auto i = static_cast<int>(
        std::upper_bound(sums, last, u, [](double value, Sum sum) { return value < sum; }) - sums);
    const double first = i == 0 ? 0.0 : double{sums[i - 1]};
    u = std::clamp((u - first) / (sums[i] - first), 0.0, 1.0);
    return i;
}

template <typename Sum>
double probability(const Sum* sums, int i)
{
    return sums[i] - (i == 0 ? 0.0 : double{sums[i - 1]});
}

/// Appends the running sums of the pixels of a row, and adds to `map.flux`.  Returns the flux of
/// the row's largest channels.
double add_row(EnvironmentMap& map, int row)
{
    const int width = map.radiance.width;
    double sum = 0;
    glm::dvec3 sums(0);
    for (int x = 0; x < width; ++x) {
        sum += max_channel(map.radiance.at(x, row));
        sums += glm::dvec3(map.radiance.at(x, row));
    }
    map.flux += sums * solid_angle(map, row);
    double so_far = 0;
    for (int x = 0; x < width; ++x) {
        so_far += max_channel(map.radiance.at(x, row));
        map.columns.push_back(sum > 0 ? static_cast<float>(so_far / sum) : 0.0f);
    }
    map.columns.back() = 1;
    return sum * solid_angle(map, row);
}

} // namespace

EnvironmentMap make_environment_map(const Image& image, float strength, float turn)
{
    EnvironmentMap map;
    map.radiance = image;
    map.turn = turn;
    for (Rgb& pixel : map.radiance.pixels)
        pixel *= strength;
    map.columns.reserve(map.radiance.pixels.size());
    for (int row = 0; row < map.radiance.height; ++row) {
        map.brightest_flux += add_row(map, row);
        map.rows.push_back(map.brightest_flux);
    }
    if (!(map.brightest_flux > 0))
        return {};
    // The last row that emits ends at 1, so that no black one below it is ever drawn.
    const double whole = map.rows.back();
    for (double& sum : map.rows)
        sum = sum == whole ? 1 : sum / whole;
    return map;
}

std::uint64_t checksum(const EnvironmentMap& map)
{
    std::uint64_t sum = mix_bits(static_cast<std::uint64_t>(map.radiance.width));
    const auto add = [&sum](float value) {
        sum = mix_bits(sum + std::bit_cast<std::uint32_t>(value));
    };
    add(map.turn);
    for (const Rgb& pixel : map.radiance.pixels)
        for (int c = 0; c < 3; ++c)
            add(pixel[c]);
    return sum;
}

MapPoint at_direction(const EnvironmentMap& map, const glm::vec3& direction)
{
    const Pixel pixel = pixel_at(map, place_towards(map, direction));
    const float* const row =
        map.columns.data() + static_cast<std::ptrdiff_t>(pixel.y) * map.radiance.width;
    return {map.radiance.at(pixel.x, pixel.y),
            static_cast<float>(probability(map.rows.data(), pixel.y) * probability(row, pixel.x) /
                               solid_angle(map, pixel.y))};
}

glm::vec3 sample_direction(const EnvironmentMap& map, const glm::vec2& u)
{
    double across = u.x, down = u.y;
    const int width = map.radiance.width;
    const int y = draw(map.rows.data(), map.radiance.height, down);
    const int x = draw(map.columns.data() + static_cast<std::ptrdiff_t>(y) * width, width, across);
    const double upper = edge_cosine(map, y);
    const double cosine = upper + down * (edge_cosine(map, y + 1) - upper);
    const double azimuth = 2 * pi * ((x + across) / width - 0.5) - map.turn;
    const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    return {static_cast<float>(sine * std::cos(azimuth)), static_cast<float>(cosine),
            static_cast<float>(sine * std::sin(azimuth))};
}

glm::vec2 direction_sample_of(const EnvironmentMap& map, const glm::vec3& direction)
{
    const int width = map.radiance.width;
    const glm::dvec2 place = place_towards(map, direction);
    const Pixel pixel = pixel_at(map, place);
    const float* const row = map.columns.data() + static_cast<std::ptrdiff_t>(pixel.y) * width;
    const double upper = edge_cosine(map, pixel.y);
    const double down = (double{direction.y} - upper) / (edge_cosine(map, pixel.y + 1) - upper);
    const double across = place.x - pixel.x;
    return {static_cast<float>(row[pixel.x] - (1 - across) * probability(row, pixel.x)),
            static_cast<float>(map.rows[static_cast<std::size_t>(pixel.y)] -
                               (1 - down) * probability(map.rows.data(), pixel.y))};
}

} // namespace hipmap
