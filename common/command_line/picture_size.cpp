#include "common/command_line/picture_size.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>

namespace hipmap {

namespace {

int parse_pixels(const std::string& digits, const std::string& text)
{
    int value = 0;
    const bool number = !digits.empty() && digits.size() <= 5 &&
                        digits.find_first_not_of("0123456789") == std::string::npos;
    if (number)
        value = std::stoi(digits);
    if (value < 1 || value > kMostPixelsAcross)
        throw CLI::ValidationError("--size", "'" + text +
                                                 "' is not an image size; write WIDTHxHEIGHT or "
                                                 "WIDTH in pixels, 1 to 65536, or a percentage");
    return value;
}

/// Returns `text` percent of a size; a side of 0 stays.
PictureSize share_of(const PictureSize& whole, const std::string& text)
{
    double percent = 0;
    if (!CLI::detail::lexical_cast(text.substr(0, text.size() - 1), percent))
        percent = 0; // refused below
    const auto share = [&](int side) {
        const double pixels = side * percent / 100;
        if (side == 0 || (pixels > 0 && pixels < 1))
            return std::min(side, 1);
        const bool possible = pixels <= kMostPixelsAcross;
        return parse_pixels(possible ? std::to_string(std::lround(pixels)) : "", text);
    };
    return {share(whole.width), share(whole.height)};
}

} // namespace

PictureSize parse_picture_size(const std::string& text, const PictureSize& whole)
{
    if (text.ends_with('%'))
        return share_of(whole, text);
    const std::size_t cross = text.find_first_of("xX");
    if (cross == std::string::npos)
        return {parse_pixels(text, text), 0};
    return {parse_pixels(text.substr(0, cross), text), parse_pixels(text.substr(cross + 1), text)};
}

PictureSize complete_size(PictureSize size, float aspect)
{
    if (size.height == 0) {
        const double height = std::round(size.width / (aspect > 0 ? double{aspect} : 1.0));
        size.height = static_cast<int>(std::clamp(height, 1.0, double{kMostPixelsAcross}));
    }
    return size;
}

} // namespace hipmap
