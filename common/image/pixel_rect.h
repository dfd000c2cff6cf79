#pragma once

namespace hipmap {

/// A rectangle of pixels of an image, from the top left; the pixels of x1 and y1 are outside.
struct PixelRect {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

    int width() const { return x1 - x0; }
    int height() const { return y1 - y0; }
    bool empty() const { return x1 <= x0 || y1 <= y0; }
    bool operator==(const PixelRect&) const = default;
};

/// The place of an image in a larger one that it is a part of.
struct ImagePlace {
    int x = 0, y = 0;                      ///< of its first pixel
    int whole_width = 0, whole_height = 0; ///< of the larger image; 0: the image is whole

    bool operator==(const ImagePlace&) const = default;
};

} // namespace hipmap
