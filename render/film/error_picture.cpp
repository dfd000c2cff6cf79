#include "render/film/error_picture.h"

#include "common/image/colour_scale.h"
#include "common/image/srgb.h"
#include "common/math/square.h"
#include "render/film/image_error.h"

namespace hipmap {

namespace {

constexpr double kLeastShown = 1e-3;

/// c of docs/error.md (3)
double dark_square(const Film& film, const Image& image)
{
    double sum = 0, pixels = 0;
    for (const Rgb& pixel : image.pixels)
        for (int c = 0; c < 3; ++c)
            sum += pixel[c];
    for (const FilmPart& part : parts_of(film))
        pixels += static_cast<double>(part.pixels.width()) * part.pixels.height();
    return pixels == 0 ? 0 : square_of(0.1 * sum / (3 * pixels));
}

/// Whether the error of a pixel can be known.
bool in_two_batches(const KeptPasses& kept, std::size_t pixel)
{
    int batches = 0;
    for (std::uint64_t batch = 0; batch < kBatches; ++batch)
        batches += kept.of_batch(pixel, batch) > 0 ? 1 : 0;
    return batches > 1;
}

} // namespace

std::vector<double> relative_errors(const Film& film)
{
    return relative_to_image(film, error_layers(film).error);
}

std::vector<double> relative_to_image(const Film& film, const Image& errors)
{
    const Image image = film_image(film);
    const double dark = dark_square(film, image);
    const KeptPasses kept(film);
    std::vector<double> out(image.pixels.size());
    for (std::size_t i = 0; i < out.size(); ++i) {
        double sum = 0;
        for (int c = 0; c < 3; ++c)
            if (errors.pixels[i][c] > 0)
                sum += square_of(errors.pixels[i][c]) / (square_of(image.pixels[i][c]) + dark);
        out[i] = film.parts.empty() || in_two_batches(kept, i) ? std::sqrt(sum / 3) : 1;
    }
    return out;
}

Image error_picture(int width, int height, const std::vector<double>& errors)
{
    Image out(width, height);
    for (std::size_t i = 0; i < out.pixels.size(); ++i) {
        const double shown = std::max(errors[i], kLeastShown);
        const Rgb linear = scale_colour(1 - std::log(shown) / std::log(kLeastShown));
        for (int c = 0; c < 3; ++c)
            out.pixels[i][c] = srgb_from_linear(linear[c]);
    }
    return out;
}

std::vector<LegendEntry> legend_of_errors(const std::string& of)
{
    constexpr int kSteps = 96;
    LegendEntry scale;
    for (int i = 0; i < kSteps; ++i)
        scale.colours.push_back(scale_colour(i / (kSteps - 1.0)));
    scale.text = of + ": 0.1 to 100 %, logarithmic";
    return {scale};
}

} // namespace hipmap
