#include "common/image/image_format.h"

#include "common/input_error.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace hipmap {

ImageFormat image_format(const std::filesystem::path& path)
{
    static constexpr std::array<std::pair<std::string_view, ImageFormat>, 5> kFormats = {{
        {".exr", ImageFormat::exr},
        {".pfm", ImageFormat::pfm},
        {".hdr", ImageFormat::hdr},
        {".png", ImageFormat::png},
        {".ppm", ImageFormat::ppm},
    }};
    std::string suffix = path.extension().string();
    std::transform(suffix.begin(), suffix.end(), suffix.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    for (const auto& [known, format] : kFormats)
        if (suffix == known)
            return format;
    throw InputError(path.string() + ": not the name of an image; use the suffix .exr, .pfm, "
                                     ".hdr, .png or .ppm");
}

} // namespace hipmap
