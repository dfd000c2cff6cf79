#include "common/file/output_file.h"
#include "common/image/exr_file.h"
#include "common/image/png_file.h"
#include "common/image/read_image.h"
#include "common/image/srgb.h"
#include "common/image/write_image.h"
#include "common/input_error.h"
#include "common/math/random.h"
#include "tests/support/overwrite.h"
#include "tests/support/temporary_folder.h"

#include <catch2/catch.hpp>
#include <stb/stb_image.h>
#include <tbb/global_control.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace hipmap {

namespace fs = std::filesystem;
using Catch::Matchers::Contains;

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// No two pixels alike, no symmetry; wide enough for the run-length code of Radiance HDR.
Image ramp_image()
{
    Image image(13, 7);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            image.at(x, y) = {0.01f * x + 0.003f, 0.1f * y, 0.05f * x * y};
    return image;
}

Image broken_image()
{
    Image image(9, 1);
    image.pixels = {Rgb(kNan),     Rgb(kInfinity), Rgb(-kInfinity),    Rgb(-1.0f), Rgb(3e38f),
                    Rgb(-3.0e38f), Rgb(1e-45f),    {kNan, 0.5f, 1.0f}, Rgb(0.25f)};
    return image;
}

struct Pixels {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> levels;
};

Pixels decode(const fs::path& path)
{
    Pixels out;
    const std::unique_ptr<stbi_uc, void (*)(void*)> levels(
        stbi_load(path.c_str(), &out.width, &out.height, nullptr, 3), stbi_image_free);
    REQUIRE(levels != nullptr);
    out.levels.assign(levels.get(), levels.get() + 3 * out.width * out.height);
    return out;
}

std::string read_error(const fs::path& path)
{
    try {
        read_image(path);
    } catch (const InputError& error) {
        return error.what();
    }
    return "no InputError";
}

std::string bytes_of(const fs::path& path)
{
    const std::vector<std::byte> bytes = read_file(path);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

} // namespace

TEST_CASE("write_image: EXR and PFM come back bit for bit", "[image]")
{
    const TemporaryFolder folder;
    const Image image = ramp_image();
    for (const char* name : {"a.exr", "a.pfm", "A.EXR"}) {
        write_image(folder / name, image, {.exposure_ev = 3});
        const Image back = read_image(folder / name);
        CHECK(back.width == image.width);
        CHECK(back.height == image.height);
        CHECK(back.pixels == image.pixels);
    }
}

TEST_CASE("write_image: HDR comes back within the step of its shared exponent", "[image]")
{
    const TemporaryFolder folder;
    const Image image = ramp_image();
    write_image(folder / "a.hdr", image, {.exposure_ev = 3});
    const Image back = read_image(folder / "a.hdr");
    REQUIRE(back.width == image.width);
    REQUIRE(back.height == image.height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const float step = max_channel(image.pixels[i]) / 128;
        for (int c = 0; c < 3; ++c) {
            CHECK(back.pixels[i][c] <= image.pixels[i][c]);
            CHECK(back.pixels[i][c] >= image.pixels[i][c] - step);
        }
    }
}

TEST_CASE("write_image: PNG and PPM hold the exposed, clipped, encoded levels", "[image]")
{
    const TemporaryFolder folder;
    const Image image = ramp_image();
    for (const char* name : {"a.png", "a.ppm"}) {
        write_image(folder / name, image, {.exposure_ev = 1});
        const Pixels pixels = decode(folder / name);
        REQUIRE(pixels.width == image.width);
        REQUIRE(pixels.height == image.height);
        for (std::size_t i = 0; i < pixels.levels.size(); ++i) {
            const float linear = 2 * image.pixels[i / 3][static_cast<int>(i % 3)];
            CHECK(int(pixels.levels[i]) == int(level_of(srgb_from_linear(linear))));
        }
    }
    CHECK(bytes_of(folder / "a.ppm").substr(0, 12) == "P6\n13 7\n255\n");
}

TEST_CASE("write_display_png: display values are not encoded again", "[image]")
{
    const TemporaryFolder folder;
    Image picture(2, 1);
    picture.pixels = {{0.0f, 0.5f, 1.0f}, {-1.0f, 2.0f, 0.2f}};
    write_display_png(folder / "a.png", picture);
    CHECK(decode(folder / "a.png").levels == std::vector<std::uint8_t>{0, 128, 255, 0, 255, 51});
}

TEST_CASE("encode_png: noise and areas of one colour come back, noise smaller as a render",
          "[image]")
{
    const TemporaryFolder folder;
    constexpr int kWidth = 301, kHeight = 200;
    std::vector<std::uint8_t> noise, areas;
    for (int i = 0; i < 3 * kWidth * kHeight; ++i) {
        noise.push_back(static_cast<std::uint8_t>(100 + mix_bits(i) % 9));
        areas.push_back(
            static_cast<std::uint8_t>(i / 3 % kWidth / 100 + 40 * (i / 3 / kWidth / 50)));
    }
    const auto size_of = [&](const std::vector<std::uint8_t>& levels, PictureKind kind) {
        const std::vector<std::byte> bytes = encode_png(kWidth, kHeight, levels, kind);
        write_file(folder / "a.png", bytes);
        CHECK(decode(folder / "a.png").levels == levels);
        return bytes.size();
    };
    CHECK(size_of(noise, PictureKind::render) < size_of(noise, PictureKind::diagram));
    CHECK(size_of(noise, PictureKind::render) < noise.size() / 2);
    CHECK(size_of(areas, PictureKind::render) < areas.size() / 100);
    CHECK(size_of(areas, PictureKind::diagram) < areas.size() / 100);
}

TEST_CASE("write_image: any number of threads writes the same PNG", "[image]")
{
    const TemporaryFolder folder;
    Image image(401, 203); // more than one part
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = Rgb(static_cast<float>(i) / static_cast<float>(image.pixels.size()));
    for (const std::size_t threads : {1, 2, 7}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        write_image(folder / (std::to_string(threads) + ".png"), image, {-1});
    }
    const Pixels decoded = decode(folder / "1.png");
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        REQUIRE(decoded.levels[3 * i + 1] == level_of(srgb_from_linear(image.pixels[i].y / 2)));
    CHECK(bytes_of(folder / "1.png") == bytes_of(folder / "2.png"));
    CHECK(bytes_of(folder / "1.png") == bytes_of(folder / "7.png"));
}

TEST_CASE("write_image: what is not finite is written as 0", "[image]")
{
    const TemporaryFolder folder;
    const Image image = broken_image();
    for (const char* name : {"a.exr", "a.pfm"}) {
        write_image(folder / name, image, {});
        const Image back = read_image(folder / name);
        CHECK(back.pixels[0] == Rgb(0.0f));
        CHECK(back.pixels[1] == Rgb(0.0f));
        CHECK(back.pixels[2] == Rgb(0.0f));
        CHECK(back.pixels[3] == Rgb(-1.0f));
        CHECK(back.pixels[4] == Rgb(3e38f));
        CHECK(back.pixels[7] == Rgb(0.0f, 0.5f, 1.0f));
    }
    write_image(folder / "a.hdr", image, {});
    const Image back = read_image(folder / "a.hdr");
    CHECK(back.pixels[0] == Rgb(0.0f));
    CHECK(back.pixels[3] == Rgb(0.0f));
    CHECK(back.pixels[4].x > 1e37f);
    CHECK(back.pixels[8] == Rgb(0.25f));
    for (const char* name : {"a.png", "a.ppm"}) {
        write_image(folder / name, image, {.exposure_ev = 200});
        const std::vector<std::uint8_t> levels = decode(folder / name).levels;
        CHECK(int(levels[0]) == 0);
        CHECK(int(levels[3]) == 0);
        CHECK(int(levels[9]) == 0);
        CHECK(int(levels[12]) == 255);
        CHECK(int(levels[24]) == 255);
    }
}

TEST_CASE("write_exr: layers come back under their names, and nothing else is in the file",
          "[image]")
{
    const TemporaryFolder folder;
    const Image image = ramp_image();
    Image error = image;
    for (Rgb& pixel : error.pixels)
        pixel = Rgb(0.5f) - pixel;
    const std::vector<Layer> layers = {{"error", &error}};
    write_exr(folder / "a.exr", image, layers);
    write_exr(folder / "b.exr", image, layers);
    CHECK(read_exr(folder / "a.exr").pixels == image.pixels);
    CHECK(read_exr(folder / "a.exr", "error").pixels == error.pixels);
    CHECK_THROWS_WITH(read_exr(folder / "a.exr", "depth"), Contains("no channel depth.R"));
    CHECK(bytes_of(folder / "a.exr") == bytes_of(folder / "b.exr"));
}

TEST_CASE("write_exr: any number of threads writes the same bytes", "[image]")
{
    const TemporaryFolder folder;
    Image image(50, 100); // several blocks of rows
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = Rgb(std::sin(static_cast<float>(i)));
    for (const std::size_t threads : {1, 2, 7}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        write_exr(folder / (std::to_string(threads) + ".exr"), image, {});
    }
    CHECK(bytes_of(folder / "1.exr") == bytes_of(folder / "2.exr"));
    CHECK(bytes_of(folder / "1.exr") == bytes_of(folder / "7.exr"));
}

TEST_CASE("image_format: an unknown suffix is refused and the known ones are listed", "[image]")
{
    const TemporaryFolder folder;
    for (const char* name : {"a.jpg", "a", "png", ".png", "a.png.txt"})
        CHECK_THROWS_WITH(write_image(folder / name, ramp_image(), {}),
                          Contains(name) && Contains(".exr, .pfm, .hdr, .png or .ppm"));
    CHECK(folder.file_count() == 0);
}

TEST_CASE("read_image: a file cut short anywhere is refused", "[image]")
{
    const TemporaryFolder folder;
    for (const char* name : {"a.exr", "a.pfm", "a.hdr"}) {
        write_image(folder / name, ramp_image(), {});
        const std::string whole = bytes_of(folder / name);
        for (std::size_t size = 0; size < whole.size(); ++size) {
            overwrite(folder / name, std::string_view(whole).substr(0, size));
            const std::string error = read_error(folder / name);
            CAPTURE(name, size);
            CHECK_THAT(error, Contains((folder / name).string()));
            CHECK(error.find('\n') == std::string::npos);
        }
    }
}

TEST_CASE("read_image: damaged headers and pixels that are not finite are refused", "[image]")
{
    const TemporaryFolder folder;
    const auto error = [&](std::string_view text) {
        write_file(folder / "a.pfm", text);
        return read_error(folder / "a.pfm");
    };
    CHECK_THAT(error("P6\n1 1\n255\nabc"), Contains("not a PFM file"));
    CHECK_THAT(error("PF\n-1 1\n-1.0\nabc"), Contains("header"));
    CHECK_THAT(error("PF\n2147483647 2147483647\n-1.0\nabc"), Contains("header"));
    CHECK_THAT(error("PF\n1 1\n0\n123456789012"), Contains("header"));
    CHECK_THAT(error("PF\n1 1\n-1.0\n12345678901"), Contains("11 bytes"));
    CHECK_THAT(error(std::string("Pf\n1 1\n-1\n\0\0\x80\x7f", 14)),
               Contains("pixel (0, 0) is not finite"));
    CHECK_THAT(read_error(folder / "a.png"), Contains("hold no radiance"));
}

TEST_CASE("read_image: PFM may be grey and big endian", "[image]")
{
    const TemporaryFolder folder;
    write_file(folder / "a.pfm", std::string_view("Pf\n1 2\n1.0\n\x3f\x80\0\0\x40\0\0\0", 19));
    const Image image = read_image(folder / "a.pfm");
    REQUIRE(image.height == 2);
    CHECK(image.at(0, 0) == Rgb(2.0f));
    CHECK(image.at(0, 1) == Rgb(1.0f));
}

} // namespace hipmap
