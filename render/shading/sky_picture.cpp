#include "render/shading/sky_picture.h"

#include "common/math/random.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace hipmap {

namespace {

using std::numbers::pi;

/// Of the upper edge of a row, counted from the top.
double edge_cosine(const SkyPicture& sky, int row)
{
    return std::cos(pi * row / sky.radiance.height);
}

/// Of each pixel of a row.
double solid_angle(const SkyPicture& sky, int row)
{
    return 2 * pi / sky.radiance.width * (edge_cosine(sky, row) - edge_cosine(sky, row + 1));
}

struct Pixel {
    int x, y;
};

Pixel pixel_towards(const SkyPicture& sky, const glm::vec3& direction)
{
    const int width = sky.radiance.width, height = sky.radiance.height;
    const double turned =
        0.5 + (std::atan2(double{direction.z}, double{direction.x}) + sky.turn) / (2 * pi);
    const double u = turned - std::floor(turned);
    const double v = std::acos(std::clamp(double{direction.y}, -1.0, 1.0)) / pi;
    return {std::min(static_cast<int>(u * width), width - 1),
            std::min(static_cast<int>(v * height), height - 1)};
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
double chance(const Sum* sums, int i)
{
    return sums[i] - (i == 0 ? 0.0 : double{sums[i - 1]});
}

/// Running sums of the pixels of a row, over their sum, which is returned.
double add_row(SkyPicture& sky, int row)
{
    const int width = sky.radiance.width;
    double sum = 0;
    for (int x = 0; x < width; ++x)
        sum += max_channel(sky.radiance.at(x, row));
    double so_far = 0;
    for (int x = 0; x < width; ++x) {
        so_far += max_channel(sky.radiance.at(x, row));
        sky.columns.push_back(sum > 0 ? static_cast<float>(so_far / sum) : 0.0f);
    }
    sky.columns.back() = 1;
    return sum;
}

} // namespace

SkyPicture make_sky_picture(const Image& picture, float strength, float turn)
{
    SkyPicture sky;
    sky.radiance = picture;
    sky.turn = turn;
    for (Rgb& pixel : sky.radiance.pixels)
        pixel *= strength;
    sky.columns.reserve(sky.radiance.pixels.size());
    for (int row = 0; row < sky.radiance.height; ++row) {
        sky.flux += add_row(sky, row) * solid_angle(sky, row);
        sky.rows.push_back(sky.flux);
    }
    if (!(sky.flux > 0))
        return {};
    // The last row that shines ends at 1, so that no black one below it is ever drawn.
    const double whole = sky.rows.back();
    for (double& sum : sky.rows)
        sum = sum == whole ? 1 : sum / whole;
    return sky;
}

std::uint64_t checksum(const SkyPicture& sky)
{
    std::uint64_t sum = mix_bits(static_cast<std::uint64_t>(sky.radiance.width));
    const auto add = [&sum](float value) {
        sum = mix_bits(sum + std::bit_cast<std::uint32_t>(value));
    };
    add(sky.turn);
    for (const Rgb& pixel : sky.radiance.pixels)
        for (int c = 0; c < 3; ++c)
            add(pixel[c]);
    return sum;
}

Rgb sky_radiance(const SkyPicture& sky, const glm::vec3& direction)
{
    const Pixel pixel = pixel_towards(sky, direction);
    return sky.radiance.at(pixel.x, pixel.y);
}

float sky_density(const SkyPicture& sky, const glm::vec3& direction)
{
    const Pixel pixel = pixel_towards(sky, direction);
    const float* const row =
        sky.columns.data() + static_cast<std::ptrdiff_t>(pixel.y) * sky.radiance.width;
    return static_cast<float>(chance(sky.rows.data(), pixel.y) * chance(row, pixel.x) /
                              solid_angle(sky, pixel.y));
}

glm::vec3 sample_sky(const SkyPicture& sky, const glm::vec2& u)
{
    double across = u.x, down = u.y;
    const int width = sky.radiance.width;
    const int y = draw(sky.rows.data(), sky.radiance.height, down);
    const int x = draw(sky.columns.data() + static_cast<std::ptrdiff_t>(y) * width, width, across);
    const double upper = edge_cosine(sky, y);
    const double cosine = upper + down * (edge_cosine(sky, y + 1) - upper);
    const double azimuth = 2 * pi * ((x + across) / width - 0.5) - sky.turn;
    const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    return {static_cast<float>(sine * std::cos(azimuth)), static_cast<float>(cosine),
            static_cast<float>(sine * std::sin(azimuth))};
}

} // namespace hipmap
