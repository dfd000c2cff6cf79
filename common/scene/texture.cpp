#include "common/scene/texture.h"

#include "common/freed_memory.h"
#include "common/scene/texture_cache.h"

#include <xxhash.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace hipmap {

namespace {

constexpr int kLevels = 256;

/// Linear values of the levels of sRGB, IEC 61966-2-1.
std::array<float, kLevels> make_srgb_table()
{
    std::array<float, kLevels> table{};
    for (int level = 0; level < kLevels; ++level) {
        const double value = level / 255.0;
        table[static_cast<std::size_t>(level)] = static_cast<float>(
            value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4));
    }
    return table;
}

std::array<std::uint8_t, 4> bytes_of_pixel(const TextureImage& image, int x, int y)
{
    std::array<std::uint8_t, 4> rgba;
    if (image.cached) {
        const std::uint32_t found =
            image.cached->cache->pixel(image.cached->first_tile, image.width, x, y);
        std::memcpy(rgba.data(), &found, sizeof found);
        return rgba;
    }
    const std::size_t at = static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                           static_cast<std::size_t>(x);
    std::memcpy(rgba.data(), image.rgba.data() + 4 * at, sizeof rgba);
    return rgba;
}

glm::vec4 pixel(const TextureImage& image, bool srgb, int x, int y)
{
    static const std::array<float, kLevels> kLinear = make_srgb_table();
    const std::array<std::uint8_t, 4> rgba = bytes_of_pixel(image, x, y);
    const auto level = [&](int c) {
        const std::uint8_t byte = rgba[static_cast<std::size_t>(c)];
        return srgb ? kLinear[byte] : static_cast<float>(byte) / 255.0f;
    };
    return {level(0), level(1), level(2), static_cast<float>(rgba[3]) / 255.0f};
}

/// A coordinate brought into [0, 1]; in double, so that far ones keep their fraction.
double wrapped(float coordinate, Wrap wrap)
{
    const double t = std::isfinite(coordinate) ? coordinate : 0.0;
    switch (wrap) {
    case Wrap::repeat:
        return t - std::floor(t);
    case Wrap::mirror: {
        const double two = t - 2.0 * std::floor(0.5 * t);
        return two <= 1.0 ? two : 2.0 - two;
    }
    case Wrap::clamp:
        break;
    }
    return std::clamp(t, 0.0, 1.0);
}

/// The pixels on both sides of a wrapped coordinate and the share of the second.
struct Neighbours {
    int first = 0, second = 0;
    float share = 0.0f;
};

Neighbours neighbours(double t, int size, Wrap wrap)
{
    const double at = t * size - 0.5;
    const double below = std::floor(at);
    const auto inside = [&](int i) {
        if (wrap == Wrap::repeat)
            return i < 0 ? size - 1 : i % size;
        return std::clamp(i, 0, size - 1); // a mirror image begins with the same pixel
    };
    const int first = static_cast<int>(below);
    return {inside(first), inside(first + 1), static_cast<float>(at - below)};
}

int nearest(double t, int size)
{
    return std::min(static_cast<int>(t * size), size - 1);
}

} // namespace

const TextureSlot* find_texture(const std::vector<TextureSlot>& slots, TextureUse use)
{
    const auto found = std::find_if(slots.begin(), slots.end(),
                                    [&](const TextureSlot& slot) { return slot.use == use; });
    return found == slots.end() ? nullptr : &*found;
}

void move_to_cache(TextureImage& image, const std::shared_ptr<TextureCache>& cache)
{
    const CachedPixels cached{cache, cache->add(image.rgba, image.width, image.height),
                              has_alpha(image), pixel_digest(image)};
    free_array(image.rgba);
    image.cached = cached;
}

TextureImage in_memory(const TextureImage& image)
{
    TextureImage out = image;
    if (image.cached)
        out.rgba = image.cached->cache->image(image.cached->first_tile, image.width, image.height);
    out.cached.reset();
    return out;
}

PixelDigest pixel_digest(const TextureImage& image)
{
    if (image.cached)
        return image.cached->digest;
    const XXH128_hash_t hash = XXH3_128bits(image.rgba.data(), image.rgba.size());
    return {hash.low64, hash.high64};
}

bool has_alpha(const TextureImage& image)
{
    if (image.cached)
        return image.cached->has_alpha;
    for (std::size_t alpha = 3; alpha < image.rgba.size(); alpha += 4)
        if (image.rgba[alpha] < 255)
            return true;
    return false;
}

TextureBytes bytes_of_textures(const std::vector<TextureImage>& images)
{
    TextureBytes bytes;
    for (const TextureImage& image : images)
        bytes.all +=
            4 * static_cast<std::uint64_t>(image.width) * static_cast<std::uint64_t>(image.height);
    const bool cached = !images.empty() && images.front().cached;
    bytes.in_memory =
        cached ? std::min(bytes.all, images.front().cached->cache->capacity()) : bytes.all;
    return bytes;
}

glm::vec4 sample_texture(const TextureImage& image, const Sampler& sampler, glm::vec2 uv)
{
    if (image.width < 1 || image.height < 1)
        return glm::vec4(1.0f);
    const double u = wrapped(uv.x, sampler.wrap_u), v = wrapped(uv.y, sampler.wrap_v);
    if (sampler.magnify == Filter::nearest)
        return pixel(image, sampler.srgb, nearest(u, image.width), nearest(v, image.height));
    const Neighbours x = neighbours(u, image.width, sampler.wrap_u);
    const Neighbours y = neighbours(v, image.height, sampler.wrap_v);
    const auto row = [&](int j) {
        return glm::mix(pixel(image, sampler.srgb, x.first, j),
                        pixel(image, sampler.srgb, x.second, j), x.share);
    };
    return glm::mix(row(y.first), row(y.second), y.share);
}

bool is_finite_transform(const glm::mat3x2& m)
{
    for (int column = 0; column < 3; ++column)
        if (!std::isfinite(m[column].x) || !std::isfinite(m[column].y))
            return false;
    return true;
}

} // namespace hipmap
