#include "common/scene/height_map.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace hipmap {

namespace {

constexpr int kGreyDifference = 8;       ///< of channels of a grey pixel in a JPEG
constexpr float kLengthTolerance = 0.2f; ///< of a normal in 8 bits, compressed

float channel(const TextureImage& image, std::size_t pixel, std::size_t index)
{
    return static_cast<float>(image.rgba[4 * pixel + index]) / 255;
}

bool is_grey(const TextureImage& image, std::size_t pixel)
{
    const auto [low, high] =
        std::minmax({image.rgba[4 * pixel], image.rgba[4 * pixel + 1], image.rgba[4 * pixel + 2]});
    return high - low <= kGreyDifference;
}

bool is_outward_normal(const TextureImage& image, std::size_t pixel)
{
    const glm::vec3 n = 2.0f * glm::vec3(channel(image, pixel, 0), channel(image, pixel, 1),
                                         channel(image, pixel, 2)) -
                        1.0f;
    return n.z > 0 && std::abs(glm::length(n) - 1) < kLengthTolerance;
}

/// A coordinate beyond the edge, brought into the image.
int inside(int at, int size, Wrap edge)
{
    return edge == Wrap::clamp ? std::clamp(at, 0, size - 1) : (at + size) % size;
}

/// Heights by pixel.
struct Heights {
    const TextureImage& image;
    Wrap edge;

    float at(int x, int y) const
    {
        const auto pixel = static_cast<std::size_t>(inside(y, image.height, edge)) *
                               static_cast<std::size_t>(image.width) +
                           static_cast<std::size_t>(inside(x, image.width, edge));
        return 0.2126f * channel(image, pixel, 0) + 0.7152f * channel(image, pixel, 1) +
               0.0722f * channel(image, pixel, 2);
    }

    /// The change of the height from a pixel to the next one, to the right and downwards.
    glm::vec2 slope(int x, int y) const
    {
        glm::vec2 out(0);
        for (int step = -1; step <= 1; ++step) {
            const float weight = step == 0 ? 2 : 1;
            out.x += weight * (at(x + 1, y + step) - at(x - 1, y + step));
            out.y += weight * (at(x + step, y + 1) - at(x + step, y - 1));
        }
        return out / 8.0f;
    }
};

std::uint8_t byte_of(float component)
{
    return static_cast<std::uint8_t>(std::lround(255 * (0.5f * component + 0.5f)));
}

} // namespace

bool holds_normals(const TextureImage& image)
{
    const std::size_t pixels = image.rgba.size() / 4;
    std::size_t grey = 0, normal = 0;
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
        grey += is_grey(image, pixel) ? 1 : 0;
        normal += is_outward_normal(image, pixel) ? 1 : 0;
    }
    return grey < pixels && 10 * normal >= 9 * pixels;
}

TextureImage normals_of_heights(const TextureImage& heights, float strength, Wrap edge)
{
    TextureImage out = heights;
    const Heights field{heights, edge};
    const float scale = strength * kHeightOfWhite * static_cast<float>(heights.width);
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) {
            const glm::vec2 slope = scale * field.slope(x, y);
            // The y of a normal map points up, rows run down.
            const glm::vec3 n = glm::normalize(glm::vec3(-slope.x, slope.y, 1));
            std::uint8_t* const pixel =
                &out.rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(out.width) +
                               static_cast<std::size_t>(x))];
            for (int c = 0; c < 3; ++c)
                pixel[c] = byte_of(n[c]);
            pixel[3] = 255;
        }
    return out;
}

} // namespace hipmap
