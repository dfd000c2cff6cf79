#include "render/picture_table.h"

#include "render/film/error_picture.h"
#include "render/film/image_error.h"

#include <algorithm>
#include <cmath>

namespace hipmap {

namespace {

bool knows_error(const RenderState& state)
{
    return !state.checks.empty();
}

/// Pixels on each side over which the bias is averaged: by pixel its noise would hide it.
constexpr int kBiasMargin = 2;

/// Returns the size of the mean of a pixel and those around it.
Rgb mean_around(const Image& image, int x, int y)
{
    Rgb sum(0);
    float pixels = 0;
    for (int v = std::max(0, y - kBiasMargin); v <= std::min(image.height - 1, y + kBiasMargin);
         ++v)
        for (int u = std::max(0, x - kBiasMargin); u <= std::min(image.width - 1, x + kBiasMargin);
             ++u, ++pixels)
            sum += image.at(u, v);
    return glm::abs(sum / pixels);
}

Image smooth_bias(const Film& film)
{
    const Image bias = error_layers(film).bias;
    Image out(film.width, film.height);
    for (int y = 0; y < film.height; ++y)
        for (int x = 0; x < film.width; ++x)
            out.at(x, y) = mean_around(bias, x, y);
    return out;
}

/// relative: [pixels].
FalseColour draw_errors(const Film& film, const std::vector<double>& relative,
                        const std::string& of)
{
    return {error_picture(film.width, film.height, relative), legend_of_errors(of)};
}

constexpr PictureRow kRows[] = {
    {"error-image",
     "Write an image of the relative error of each pixel in false colour, .png. Rewritten after "
     "passes",
     "an error image needs two passes or more", knows_error,
     [](const RenderState& state) {
         return draw_errors(state.film, relative_errors(state.film), "error");
     }},
    {"bias-image",
     "Write an image of the bias by the radii of photon estimates, averaged over 5 by 5 pixels, as "
     "--error-image has errors. Rewritten after passes",
     "a bias image needs two passes or more by integrator progressive",
     [](const RenderState& state) {
         return knows_error(state) && state.film.bias == BiasKnowledge::from_radii;
     },
     [](const RenderState& state) {
         const Film& film = state.film;
         return draw_errors(film, relative_to_image(film, smooth_bias(film)), "bias");
     }},
};

} // namespace

std::span<const PictureRow> picture_rows()
{
    return kRows;
}

std::vector<RequestedPicture> requested_pictures(const std::vector<std::filesystem::path>& paths)
{
    std::vector<RequestedPicture> out;
    for (std::size_t i = 0; i < paths.size(); ++i)
        if (!paths[i].empty())
            out.push_back({&kRows[i], paths[i]});
    return out;
}

std::vector<RequestedPicture> known_pictures(const std::vector<std::filesystem::path>& paths,
                                             const RenderState& state)
{
    std::vector<RequestedPicture> out = requested_pictures(paths);
    std::erase_if(out, [&](const RequestedPicture& of) { return !of.row->is_known(state); });
    return out;
}

LegendedPicture write_picture(const RequestedPicture& picture, const RenderState& state)
{
    const FalseColour drawn = picture.row->draw(state);
    return write_with_legend(picture.path, drawn.image, drawn.legend);
}

} // namespace hipmap
