#include "bench/image_difference.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace hipmap {

glm::dvec3 mean_radiance(const Image& image)
{
    glm::dvec3 sum(0.0);
    for (const Rgb& pixel : image.pixels)
        sum += glm::dvec3(pixel);
    return image.pixels.empty() ? sum : sum / static_cast<double>(image.pixels.size());
}

double relative_mse(const Image& image, const Image& reference)
{
    assert(image.width == reference.width && image.height == reference.height);
    const glm::dvec3 mean = mean_radiance(reference);
    const double floor = 0.1 * (mean.x + mean.y + mean.z) / 3;
    double sum = 0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            const double truth = reference.pixels[i][c];
            const double error = image.pixels[i][c] - truth;
            const double scale = truth * truth + floor * floor;
            if (error != 0)
                sum += scale > 0 ? error * error / scale : std::numeric_limits<double>::infinity();
        }
    }
    return image.pixels.empty() ? 0.0 : sum / (3.0 * static_cast<double>(image.pixels.size()));
}

Image side_by_side(const Image& left, const Image& right)
{
    assert(left.height == right.height);
    Image both(left.width + right.width, left.height);
    for (int y = 0; y < both.height; ++y) {
        std::copy_n(left.pixels.begin() + std::ptrdiff_t(y) * left.width, left.width,
                    both.pixels.begin() + std::ptrdiff_t(y) * both.width);
        std::copy_n(right.pixels.begin() + std::ptrdiff_t(y) * right.width, right.width,
                    both.pixels.begin() + std::ptrdiff_t(y) * both.width + left.width);
    }
    return both;
}

} // namespace hipmap
