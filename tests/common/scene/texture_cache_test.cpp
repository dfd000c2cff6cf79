#include "common/math/random.h"
#include "common/scene/texture.h"
#include "common/scene/texture_cache.h"

#include <catch2/catch.hpp>

#include <atomic>
#include <thread>

namespace hipmap {

namespace {

constexpr std::uint64_t kTileBytes = 4 * TextureCache::kTilePixels;

/// An image whose pixels all differ.
TextureImage many_pixels(int width, int height, std::uint64_t seed)
{
    TextureImage image{"many", width, height, {}, {}};
    for (int i = 0; i < 4 * width * height; ++i)
        image.rgba.push_back(
            static_cast<std::uint8_t>(mix_bits(seed + static_cast<std::uint64_t>(i))));
    return image;
}

std::uint32_t pixel_of(const TextureImage& image, int x, int y)
{
    std::uint32_t out = 0;
    for (int c = 3; c >= 0; --c)
        out = out << 8 | image.rgba[static_cast<std::size_t>(4 * (y * image.width + x) + c)];
    return out;
}

} // namespace

TEST_CASE("TextureCache: every pixel of images of any size, whatever memory holds",
          "[scene][texture]")
{
    const std::vector<TextureImage> images = {many_pixels(1, 1, 1), many_pixels(33, 31, 2),
                                              many_pixels(32, 64, 3), many_pixels(100, 65, 4)};
    for (const std::uint64_t tiles : {0, 1, 3, 100}) {
        TextureCache cache(tiles * kTileBytes);
        CHECK(cache.capacity() == std::max<std::uint64_t>(1, tiles) * kTileBytes);
        std::vector<std::uint32_t> first;
        for (const TextureImage& image : images)
            first.push_back(cache.add(image.rgba, image.width, image.height));
        int wrong = 0;
        for (int round = 0; round < 2; ++round)
            for (std::size_t i = 0; i < images.size(); ++i)
                for (int y = 0; y < images[i].height; ++y)
                    for (int x = 0; x < images[i].width; ++x)
                        wrong += cache.pixel(first[i], images[i].width, x, y) !=
                                 pixel_of(images[i], x, y);
        CHECK(wrong == 0);
        for (std::size_t i = 0; i < images.size(); ++i)
            CHECK(cache.image(first[i], images[i].width, images[i].height) == images[i].rgba);
    }
}

TEST_CASE("TextureCache: threads that drive out each other's tiles read right pixels",
          "[scene][texture]")
{
    const TextureImage image = many_pixels(300, 200, 5);
    TextureCache cache(3 * kTileBytes);
    const std::uint32_t first = cache.add(image.rgba, image.width, image.height);
    std::atomic<int> wrong = 0;
    const auto look = [&](std::uint64_t seed) {
        for (std::uint64_t i = 0; i < 20'000; ++i) {
            const std::uint64_t bits = mix_bits(seed << 32 | i);
            // One tile that all want and any other.
            const bool hot = bits % 4 != 0;
            const int x = static_cast<int>((bits >> 8) % (hot ? 32 : 300));
            const int y = static_cast<int>((bits >> 32) % (hot ? 32 : 200));
            wrong += cache.pixel(first, image.width, x, y) != pixel_of(image, x, y);
        }
    };
    {
        std::vector<std::jthread> threads;
        for (std::uint64_t seed = 0; seed < 4; ++seed)
            threads.emplace_back(look, seed);
    }
    CHECK(wrong == 0);
}

TEST_CASE("a texture in a cache is the one in memory", "[scene][texture]")
{
    const TextureImage image = many_pixels(45, 70, 6);
    TextureImage cached = image;
    move_to_cache(cached, std::make_shared<TextureCache>(0));
    CHECK(cached.rgba.capacity() == 0); // no memory
    CHECK(in_memory(cached).rgba == image.rgba);
    CHECK(pixel_digest(cached) == pixel_digest(image));
    CHECK(has_alpha(cached));
    CHECK(bytes_of_textures({cached}).all == image.rgba.size());
    CHECK(bytes_of_textures({cached}).in_memory == kTileBytes);
    CHECK(bytes_of_textures({image}).in_memory == image.rgba.size());
    int different = 0;
    for (const Wrap wrap : {Wrap::repeat, Wrap::mirror, Wrap::clamp})
        for (const Filter filter : {Filter::linear, Filter::nearest})
            for (std::uint64_t i = 0; i < 500; ++i) {
                const Sampler sampler{wrap, wrap, filter, filter, i % 2 == 0};
                const std::uint64_t bits = mix_bits(i);
                const glm::vec2 uv(static_cast<float>(bits % 4096) / 1024 - 2,
                                   static_cast<float>((bits >> 12) % 4096) / 1024 - 2);
                different +=
                    sample_texture(image, sampler, uv) != sample_texture(cached, sampler, uv);
            }
    CHECK(different == 0);
}

TEST_CASE("has_alpha: a texture without clear pixels has none, in memory and in a cache",
          "[scene][texture]")
{
    TextureImage image{"plain", 2, 1, {1, 2, 3, 255, 4, 5, 6, 255}, {}};
    CHECK_FALSE(has_alpha(image));
    move_to_cache(image, std::make_shared<TextureCache>(0));
    CHECK_FALSE(has_alpha(image));
}

} // namespace hipmap
