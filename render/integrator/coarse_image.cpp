#include "render/integrator/coarse_image.h"

#include "render/integrator/render_options.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace hipmap {

namespace {

constexpr int kLeastBlock = 8;
constexpr int kMostBlocks = 96; ///< across the longer side

/// Two neighbouring blocks, and how much the second one counts.
struct Between {
    int first = 0, second = 0;
    float share = 0;
};

Between blocks_around(int pixel, int block, int blocks)
{
    const float at =
        (static_cast<float>(pixel) + 0.5f) / static_cast<float>(block) - 0.5f; // in blocks
    const float low = std::floor(at);
    const auto first = static_cast<int>(low);
    return {std::clamp(first, 0, blocks - 1), std::clamp(first + 1, 0, blocks - 1), at - low};
}

} // namespace

int coarse_block(const RenderOptions& options)
{
    const PixelRect pixels = rendered_pixels(options);
    const int side = std::max(pixels.width(), pixels.height());
    return std::max(kLeastBlock, (side + kMostBlocks - 1) / kMostBlocks);
}

void fill_by_coarse(const CoarseImage& coarse, const std::vector<std::uint8_t>& kept, Image& image)
{
    const Image& from = coarse.image;
    for (int y = 0; y < image.height; ++y) {
        const Between down = blocks_around(y, coarse.block, from.height);
        for (int x = 0; x < image.width; ++x) {
            if (kept[static_cast<std::size_t>(y) * image.width + x] != 0)
                continue;
            const Between across = blocks_around(x, coarse.block, from.width);
            const auto row = [&](int v) {
                return glm::mix(from.at(across.first, v), from.at(across.second, v), across.share);
            };
            image.at(x, y) = glm::mix(row(down.first), row(down.second), down.share);
        }
    }
}

} // namespace hipmap
