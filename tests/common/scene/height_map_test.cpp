#include "common/scene/height_map.h"

#include <catch2/catch.hpp>

#include <functional>

namespace hipmap {

namespace {

TextureImage image_of(int width, int height, const std::function<glm::vec3(int, int)>& colour)
{
    TextureImage out{"heights", width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const glm::vec3 c = colour(x, y);
            for (int i = 0; i < 3; ++i)
                out.rgba.push_back(static_cast<std::uint8_t>(std::lround(255 * c[i])));
            out.rgba.push_back(255);
        }
    return out;
}

glm::vec3 normal_at(const TextureImage& image, int x, int y)
{
    const std::uint8_t* const pixel =
        &image.rgba[static_cast<std::size_t>(4 * (y * image.width + x))];
    return 2.0f * glm::vec3(pixel[0], pixel[1], pixel[2]) / 255.0f - 1.0f;
}

} // namespace

TEST_CASE("height map: a ramp has the normal of its slope", "[scene][texture]")
{
    // Black to white in 51 steps of five levels each.
    const float slope = kHeightOfWhite * 52 / 51;
    for (const float strength : {1.0f, 40.0f, -40.0f}) {
        const glm::vec3 right = glm::normalize(glm::vec3(-strength * slope, 0, 1));
        const TextureImage ramp =
            image_of(52, 3, [](int x, int) { return glm::vec3(static_cast<float>(x) / 51); });
        const TextureImage normals = normals_of_heights(ramp, strength, Wrap::clamp);
        CHECK(glm::distance(normal_at(normals, 25, 1), right) < 0.01f);
    }
    // Rows run down, the y of a normal map up: what rises to the top leans to the bottom.
    const TextureImage up =
        image_of(52, 52, [](int, int y) { return glm::vec3(1 - static_cast<float>(y) / 51); });
    const glm::vec3 n = normal_at(normals_of_heights(up, 40, Wrap::clamp), 1, 25);
    CHECK(glm::distance(n, glm::normalize(glm::vec3(0, -40 * slope, 1))) < 0.01f);
}

TEST_CASE("height map: beyond its edge it repeats, or stays as it is", "[scene][texture]")
{
    const TextureImage step =
        image_of(8, 1, [](int x, int) { return glm::vec3(x < 4 ? 0.0f : 1.0f); });
    CHECK(normal_at(normals_of_heights(step, 1, Wrap::repeat), 0, 0).x > 0.01f);
    CHECK(std::abs(normal_at(normals_of_heights(step, 1, Wrap::clamp), 0, 0).x) < 0.005f);
}

TEST_CASE("height map: normal maps are recognised by their colours", "[scene][texture]")
{
    const auto coloured = [](const glm::vec3& c) {
        return image_of(4, 4, [c](int, int) { return c; });
    };
    CHECK(holds_normals(coloured({0.5f, 0.5f, 1})));
    CHECK(holds_normals(coloured({0.8f, 0.5f, 0.9f})));
    CHECK_FALSE(holds_normals(coloured(glm::vec3(0.79f)))); // grey, although of unit length
    CHECK_FALSE(holds_normals(coloured({0.6f, 0.4f, 0.2f})));
    CHECK_FALSE(holds_normals({}));
    CHECK(normals_of_heights({}, 1, Wrap::repeat).rgba.empty());
}

} // namespace hipmap
