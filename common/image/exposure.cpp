#include "common/image/exposure.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace hipmap {

float auto_exposure(const Image& image)
{
    constexpr float kDisplayed = 0.5f;
    std::vector<float> luminances;
    luminances.reserve(image.pixels.size());
    for (const Rgb& pixel : image.pixels) {
        const float value = luminance(pixel);
        if (std::isfinite(value) && value > 0)
            luminances.push_back(value);
    }
    if (luminances.empty())
        return 0.0f;

    const std::size_t rank = (9 * luminances.size() + 9) / 10; // 1 to n: ceil(0.9 n)
    const auto percentile = luminances.begin() + static_cast<std::ptrdiff_t>(rank - 1);
    std::nth_element(luminances.begin(), percentile, luminances.end());
    return std::log2(kDisplayed) - std::log2(*percentile);
}

} // namespace hipmap
