#pragma once

#include <string>

namespace hipmap {

/// Image width and height in pixels; a height of 0 follows from the camera's aspect.
struct PictureSize {
    int width = 0;
    int height = 0;
};

/// The longest side of an image.
inline constexpr int kMostPixelsAcross = 65536;

/// Parses an image size: "WxH" or "W", each 1 to 65,536, or "50%", a share of both sides of
/// `whole`.  Throws CLI::ValidationError for other text.
PictureSize parse_picture_size(const std::string& text, const PictureSize& whole);

/// Returns `size` with a missing height filled in.  aspect: width over height.
PictureSize complete_size(PictureSize size, float aspect);

} // namespace hipmap
