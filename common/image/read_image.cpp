#include "common/image/read_image.h"

#include "common/file/output_file.h"
#include "common/image/exr_file.h"
#include "common/image/image_format.h"
#include "common/input_error.h"

#include <stb/stb_image.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hipmap {

namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& what)
{
    throw InputError(path.string() + ": " + what + "; write the image again");
}

/// Takes one word and the one white space after it from the front of `text`.
std::string_view take_word(std::string_view& text)
{
    std::size_t end = 0;
    while (end < text.size() && std::isspace(static_cast<unsigned char>(text[end])) == 0)
        ++end;
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return word;
}

template <typename Number>
std::optional<Number> take_number(std::string_view& text)
{
    const std::string_view word = take_word(text);
    Number number{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc() || end != word.data() + word.size())
        return std::nullopt;
    return number;
}

float pfm_value(const char* bytes, bool little_endian)
{
    std::array<char, 4> value{};
    std::memcpy(value.data(), bytes, value.size());
    if (little_endian != (std::endian::native == std::endian::little))
        std::reverse(value.begin(), value.end());
    return std::bit_cast<float>(value);
}

Image read_pfm(const std::filesystem::path& path, const std::vector<std::byte>& bytes)
{
    std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const std::string_view magic = take_word(text);
    if (magic != "PF" && magic != "Pf")
        fail(path, "not a PFM file");
    const std::int64_t channels = magic == "PF" ? 3 : 1;
    const auto width = take_number<int>(text);
    const auto height = take_number<int>(text);
    const auto scale = take_number<float>(text); // its sign is the byte order
    if (!width || !height || !scale || !is_plausible_size(*width, *height) || *scale == 0)
        fail(path, "the header of this PFM file is damaged");
    if (static_cast<std::int64_t>(text.size()) != channels * 4 * *width * *height)
        fail(path, "the PFM file has " + std::to_string(text.size()) +
                       " bytes of pixels, which does not match its header");

    Image image(*width, *height);
    const char* at = text.data();
    for (int y = image.height; y-- > 0;) {
        for (int x = 0; x < image.width; ++x) {
            for (int c = 0; c < channels; ++c, at += 4)
                image.at(x, y)[c] = pfm_value(at, *scale < 0);
            if (channels == 1)
                image.at(x, y) = Rgb(image.at(x, y).x);
        }
    }
    return image;
}

/// Whether the line that gives the size is all there.  The header ends with an empty line.
bool has_hdr_size(std::string_view text)
{
    const std::size_t header_end = text.find("\n\n");
    return header_end != text.npos && text.find('\n', header_end + 2) != text.npos;
}

/// stb 2.27 takes the end of a truncated file for endless runs of nothing.  So the file is
/// lengthened, by more than the run-length code of the widest row can take, with bytes that decode
/// to the largest exponent, which no picture has; that is then found.
Image read_hdr(const std::filesystem::path& path, std::vector<std::byte> bytes)
{
    constexpr std::size_t kPadding = 1 << 17;
    constexpr float kPaddingValue = 0x1p126f;
    if (!has_hdr_size({reinterpret_cast<const char*>(bytes.data()), bytes.size()}))
        fail(path, "the header of this Radiance HDR file is damaged");
    bytes.insert(bytes.end(), kPadding, std::byte{0xff});
    if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
        fail(path, "the file is larger than 2 GB: scale the image down");
    const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
    const int size = static_cast<int>(bytes.size());
    int width = 0;
    int height = 0;
    if (stbi_is_hdr_from_memory(data, size) == 0)
        fail(path, "not a Radiance HDR file");
    const std::unique_ptr<float, void (*)(void*)> channels(
        stbi_loadf_from_memory(data, size, &width, &height, nullptr, 3), stbi_image_free);
    if (!channels)
        fail(path, std::string("cannot be read as Radiance HDR (") + stbi_failure_reason() + ")");

    Image image(width, height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const float* c = channels.get() + 3 * i;
        image.pixels[i] = {c[0], c[1], c[2]};
        if (max_channel(image.pixels[i]) >= kPaddingValue)
            fail(path, "the Radiance HDR file is truncated");
    }
    return image;
}

Image read_any(const std::filesystem::path& path)
{
    switch (image_format(path)) {
    case ImageFormat::exr:
        return read_exr(path);
    case ImageFormat::pfm:
        return read_pfm(path, read_file(path));
    case ImageFormat::hdr:
        return read_hdr(path, read_file(path));
    case ImageFormat::png:
    case ImageFormat::ppm:
        break;
    }
    throw InputError(path.string() + ": 8-bit images hold no radiance; use .exr, .pfm or .hdr");
}

} // namespace

Image read_image(const std::filesystem::path& path)
{
    const Image image = read_any(path);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        if (is_finite(image.pixels[i]))
            continue;
        const std::size_t width = static_cast<std::size_t>(image.width);
        fail(path, "pixel (" + std::to_string(i % width) + ", " + std::to_string(i / width) +
                       ") is not finite");
    }
    return image;
}

} // namespace hipmap
