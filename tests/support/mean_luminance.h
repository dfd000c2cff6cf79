#pragma once

#include "common/image/image.h"

namespace hipmap {

inline double mean_luminance(const Image& image)
{
    double sum = 0;
    for (const Rgb& pixel : image.pixels)
        sum += luminance(pixel);
    return sum / static_cast<double>(image.pixels.size());
}

} // namespace hipmap
