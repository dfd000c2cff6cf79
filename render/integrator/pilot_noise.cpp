#include "render/integrator/pilot_noise.h"

#include <algorithm>
#include <utility>

namespace hipmap {

namespace {

/// Light of long paths that a smaller share of samples finds is left to chance, docs/error.md (27):
/// even the pixels with the most samples have hardly more than 100,000 of them in a long render.
constexpr double kRarest = 1e-5;

struct Size {
    int width, height; ///< pixels
};

Size size_of(const Image& image)
{
    return {image.width, image.height};
}

/// Returns the pixel of an image of size `to` where pixel x, y of one of size `from` begins.
std::size_t pixel_at(int x, int y, const Size& from, const Size& to)
{
    return static_cast<std::size_t>(y * to.height / from.height) * to.width +
           x * to.width / from.width;
}

/// Pixels of a row or a column: the first one, how far apart they are, and how many they are.
struct Line {
    std::size_t first, step;
    int length;
};

/// Takes means over the pixels of a line up to `reach` away.
void blur_line(std::vector<double>& values, const Line& line, int reach)
{
    const auto [first, step, length] = line;
    std::vector<double> sums(static_cast<std::size_t>(length) + 1, 0.0);
    for (int i = 0; i < length; ++i)
        sums[static_cast<std::size_t>(i) + 1] =
            sums[static_cast<std::size_t>(i)] + values[first + static_cast<std::size_t>(i) * step];
    for (int i = 0; i < length; ++i) {
        const int begin = std::max(0, i - reach), end = std::min(length, i + reach + 1);
        values[first + static_cast<std::size_t>(i) * step] =
            (sums[static_cast<std::size_t>(end)] - sums[static_cast<std::size_t>(begin)]) /
            (end - begin);
    }
}

} // namespace

PilotBrightness brightness_of(const PilotNoise& pilot, int width, int height)
{
    PilotBrightness out;
    const Size size = size_of(pilot.first);
    double sum = 0;
    for (int y = 0; y < pilot.first.height; ++y)
        for (int x = 0; x < pilot.first.width; ++x) {
            const std::size_t lights = pixel_at(x, y, size, {width, height});
            const glm::dvec3 mean = (glm::dvec3(finite_or_black(pilot.first.at(x, y))) +
                                     glm::dvec3(finite_or_black(pilot.second.at(x, y)))) /
                                        2.0 +
                                    (pilot.lights.mean.empty() ? 0.0 : pilot.lights.mean[lights]);
            out.mean.push_back(mean);
            sum += sum_of_channels(mean);
        }
    const double mean = sum / 3 / std::max<double>(1.0, static_cast<double>(out.mean.size()));
    out.least2 = 0.01 * mean * mean;
    return out;
}

std::size_t pilot_pixel(const PilotNoise& pilot, int x, int y, int width, int height)
{
    return pixel_at(x, y, {width, height}, size_of(pilot.first));
}

Rgb finite_or_black(const Rgb& value)
{
    return is_finite(value) ? value : Rgb(0);
}

std::vector<double> blurred(std::vector<double> values, int width, int reach)
{
    const auto row = static_cast<std::size_t>(width);
    const int height = width > 0 ? static_cast<int>(values.size() / row) : 0;
    for (int y = 0; y < height; ++y)
        blur_line(values, {static_cast<std::size_t>(y) * row, 1, width}, reach);
    for (int x = 0; x < width; ++x)
        blur_line(values, {static_cast<std::size_t>(x), row, height}, reach);
    return values;
}

void blur(PilotBrightness& brightness, int width, int reach)
{
    for (int channel = 0; channel < 3; ++channel) {
        std::vector<double> values;
        for (const glm::dvec3& mean : brightness.mean)
            values.push_back(mean[channel]);
        values = blurred(std::move(values), width, reach);
        for (std::size_t i = 0; i < values.size(); ++i)
            brightness.mean[i][channel] = values[i];
    }
}

double expected_variance(const LongPaths& paths)
{
    return double{paths.mean} * paths.mean > kRarest * paths.variance
               ? kReachedShare * paths.variance
               : 0;
}

} // namespace hipmap
