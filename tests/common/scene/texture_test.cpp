#include "common/scene/texture.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

namespace hipmap {

namespace {

/// Two by two pixels:  red    green
///                     blue   half-clear grey
TextureImage four_pixels()
{
    return {"four", 2, 2, {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 128, 128, 128, 51}};
}

void check_close(const glm::vec4& a, const glm::vec4& b)
{
    for (int c = 0; c < 4; ++c)
        CHECK(a[c] == Approx(b[c]).margin(1e-6));
}

const glm::vec4 kRed(1, 0, 0, 1), kGreen(0, 1, 0, 1), kBlue(0, 0, 1, 1);
const glm::vec4 kGrey(128 / 255.0f, 128 / 255.0f, 128 / 255.0f, 0.2f);

} // namespace

TEST_CASE("sample_texture: the middle of a pixel gives its value, (0, 0) is the top left",
          "[scene][texture]")
{
    const TextureImage image = four_pixels();
    for (const Filter filter : {Filter::linear, Filter::nearest}) {
        Sampler sampler;
        sampler.magnify = filter;
        check_close(sample_texture(image, sampler, {0.25f, 0.25f}), kRed);
        check_close(sample_texture(image, sampler, {0.75f, 0.25f}), kGreen);
        check_close(sample_texture(image, sampler, {0.25f, 0.75f}), kBlue);
        check_close(sample_texture(image, sampler, {0.75f, 0.75f}), kGrey);
    }
}

TEST_CASE("sample_texture: between pixels values mix by their distance", "[scene][texture]")
{
    const TextureImage image = four_pixels();
    check_close(sample_texture(image, {}, {0.375f, 0.25f}), 0.75f * kRed + 0.25f * kGreen);
    check_close(sample_texture(image, {}, {0.5f, 0.5f}), 0.25f * (kRed + kGreen + kBlue + kGrey));
    check_close(sample_texture(image, {}, {0.25f, 0.625f}), 0.25f * kRed + 0.75f * kBlue);
}

TEST_CASE("sample_texture: sRGB is made linear before it is mixed, alpha never", "[scene][texture]")
{
    Sampler sampler;
    sampler.srgb = true;
    const TextureImage image = {"two", 2, 1, {188, 10, 0, 128, 0, 255, 0, 0}};
    // 188/255 = 0.737255 -> ((0.737255 + 0.055) / 1.055)^2.4; 10/255 lies on the straight part.
    const float bright = 0.502886f, dark = 10 / 255.0f / 12.92f;
    check_close(sample_texture(image, sampler, {0.25f, 0.5f}), {bright, dark, 0, 128 / 255.0f});
    check_close(sample_texture(image, sampler, {0.5f, 0.5f}),
                {bright / 2, (dark + 1) / 2, 0, 64 / 255.0f});
}

TEST_CASE("sample_texture: outside the texture it repeats, mirrors or keeps its edge",
          "[scene][texture]")
{
    const TextureImage image = {
        "three", 3, 1, {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255}}; // red, green, blue
    const auto at = [&](Wrap wrap, float u, Filter filter = Filter::linear) {
        return sample_texture(image, {wrap, Wrap::clamp, filter, filter, false}, {u, 0.5f});
    };
    const float third = 1 / 3.0f, middle = third / 2; // of the first pixel
    for (const float whole : {-2.0f, -1.0f, 1.0f, 5.0f})
        check_close(at(Wrap::repeat, middle + whole, Filter::nearest), kRed);
    check_close(at(Wrap::repeat, 0.0f), 0.5f * (kRed + kBlue));
    check_close(at(Wrap::repeat, 1.0f), 0.5f * (kRed + kBlue));
    check_close(at(Wrap::mirror, 1 + middle, Filter::nearest), kBlue);
    check_close(at(Wrap::mirror, 2 + middle, Filter::nearest), kRed);
    check_close(at(Wrap::mirror, -middle, Filter::nearest), kRed);
    check_close(at(Wrap::mirror, -third - middle, Filter::nearest), kGreen);
    check_close(at(Wrap::mirror, 0.0f), kRed);
    check_close(at(Wrap::mirror, 1.0f), kBlue);
    check_close(at(Wrap::clamp, -7.0f), kRed);
    check_close(at(Wrap::clamp, 7.0f, Filter::nearest), kBlue);
    check_close(at(Wrap::clamp, third), 0.5f * (kRed + kGreen));
}

TEST_CASE("sample_texture: no coordinate and no texture gives what is not in [0, 1]",
          "[scene][texture]")
{
    const float infinity = std::numeric_limits<float>::infinity();
    for (const Wrap wrap : {Wrap::repeat, Wrap::mirror, Wrap::clamp})
        for (const Filter filter : {Filter::linear, Filter::nearest})
            for (const float u : {-infinity, infinity, std::nanf(""), 3e38f, -3e38f, 1e-45f,
                                  -1e-45f, 0.99999994f, 1.0f, -0.0f}) {
                const glm::vec4 value =
                    sample_texture(four_pixels(), {wrap, wrap, filter, filter, true}, {u, u});
                for (int c = 0; c < 4; ++c)
                    CHECK((value[c] >= 0 && value[c] <= 1));
            }
    CHECK(sample_texture({}, {}, {0.5f, 0.5f}) == glm::vec4(1.0f));
}

} // namespace hipmap
