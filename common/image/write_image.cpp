#include "common/image/write_image.h"

#include "common/file/output_file.h"
#include "common/image/exr_file.h"
#include "common/image/png_file.h"
#include "common/image/srgb.h"
#include "common/input_error.h"

#include <stb/stb_image_write.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <new>
#include <span>
#include <string>
#include <vector>

namespace hipmap {

namespace {

using Levels = std::vector<std::uint8_t>; // [width * height * 3]

Levels expose(const Image& image, const Display& display)
{
    assert(!std::isnan(display.exposure_ev));
    const float scale = std::exp2(display.exposure_ev);
    Levels levels(image.pixels.size() * 3);
    constexpr std::size_t kPart = 1 << 14;
    const tbb::blocked_range<std::size_t> all(0, image.pixels.size(), kPart);
    tbb::parallel_for(all, [&](const tbb::blocked_range<std::size_t>& part) {
        const auto pixels = std::span(image.pixels).subspan(part.begin(), part.size());
        std::vector<Rgb> exposed(pixels.begin(), pixels.end());
        for (Rgb& pixel : exposed)
            for (int c = 0; c < 3; ++c)
                pixel[c] = std::isfinite(pixel[c]) ? pixel[c] * scale : 0.0f;
        if (display.view)
            display.view(exposed);
        auto level = levels.begin() + static_cast<std::ptrdiff_t>(3 * part.begin());
        for (const Rgb& pixel : exposed)
            for (int c = 0; c < 3; ++c)
                *level++ = level_of(display.view ? pixel[c] : srgb_from_linear(pixel[c]));
    });
    return levels;
}

std::string size_line(const Image& image)
{
    return std::to_string(image.width) + " " + std::to_string(image.height) + "\n";
}

void write_ppm(const std::filesystem::path& path, const Image& image, const Levels& levels)
{
    std::string text = "P6\n" + size_line(image) + "255\n";
    text.append(levels.begin(), levels.end());
    write_file(path, text);
}

/// The channels of `image`, those that are not finite or below `low` or above `high` brought back.
std::vector<float> channels_of(const Image& image, float low, float high)
{
    std::vector<float> channels;
    channels.reserve(image.pixels.size() * 3);
    for (const Rgb& pixel : image.pixels)
        for (int c = 0; c < 3; ++c)
            channels.push_back(std::isfinite(pixel[c]) ? std::clamp(pixel[c], low, high) : 0.0f);
    return channels;
}

void append_bytes(void* context, void* data, int size)
{
    auto& bytes = *static_cast<std::vector<std::byte>*>(context);
    const auto* first = static_cast<const std::byte*>(data);
    bytes.insert(bytes.end(), first, first + size);
}

/// stb counts bytes in int.
void check_stb_size(const std::filesystem::path& path, const Image& image)
{
    const std::int64_t bytes = (image.width * std::int64_t{4} + 1) * image.height;
    if (bytes > std::numeric_limits<int>::max() / 2)
        throw InputError(path.string() + ": " + std::to_string(image.width) + "x" +
                         std::to_string(image.height) +
                         " pixels are too many for this format; write .exr or .pfm");
}

void write_hdr(const std::filesystem::path& path, const Image& image)
{
    check_stb_size(path, image);
    constexpr float kLargest = 0x1.fp125f; // read_image takes the largest exponent for damage
    const std::vector<float> channels = channels_of(image, 0.0f, kLargest);
    std::vector<std::byte> bytes;
    if (stbi_write_hdr_to_func(append_bytes, &bytes, image.width, image.height, 3,
                               channels.data()) == 0)
        throw std::bad_alloc();
    write_file(path, bytes);
}

/// Little endian, rows from the bottom.
void write_pfm(const std::filesystem::path& path, const Image& image)
{
    static_assert(std::endian::native == std::endian::little);
    constexpr float kMax = std::numeric_limits<float>::max();
    const std::vector<float> channels = channels_of(image, -kMax, kMax);
    const std::size_t row = static_cast<std::size_t>(image.width) * 3;
    std::string text = "PF\n" + size_line(image) + "-1.0\n";
    for (std::size_t y = static_cast<std::size_t>(image.height); y-- > 0;) {
        const auto bytes = std::as_bytes(std::span(channels).subspan(y * row, row));
        text.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    }
    write_file(path, text);
}

} // namespace

void write_image(const std::filesystem::path& path, const Image& image, const Display& display)
{
    assert(image.width > 0 && image.height > 0);
    switch (image_format(path)) {
    case ImageFormat::exr:
        return write_exr(path, image, {});
    case ImageFormat::pfm:
        return write_pfm(path, image);
    case ImageFormat::hdr:
        return write_hdr(path, image);
    case ImageFormat::png:
        return write_file(path, encode_png(image.width, image.height, expose(image, display),
                                           PictureKind::render));
    case ImageFormat::ppm:
        return write_ppm(path, image, expose(image, display));
    }
}

void write_display_png(const std::filesystem::path& path, const Image& picture)
{
    assert(picture.width > 0 && picture.height > 0);
    Levels levels;
    levels.reserve(picture.pixels.size() * 3);
    for (const Rgb& pixel : picture.pixels)
        for (int c = 0; c < 3; ++c)
            levels.push_back(level_of(pixel[c]));
    write_file(path, encode_png(picture.width, picture.height, levels, PictureKind::diagram));
}

} // namespace hipmap
