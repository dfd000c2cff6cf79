#include "render/image_files.h"

#include "common/image/exr_file.h"
#include "render/film/image_error.h"

#include <algorithm>

namespace hipmap {

namespace {

void write_exr_with_error(const std::filesystem::path& path, const Image& image,
                          const RenderState& state)
{
    const Film& film = state.film;
    if (state.checks.empty()) {
        write_exr(path, image, {}, film.place);
        return;
    }
    const ErrorLayers layers = error_layers(film);
    std::vector<Layer> named = {{"noise", &layers.noise}, {"error", &layers.error}};
    if (!layers.bias.pixels.empty())
        named.push_back({"bias", &layers.bias});
    write_exr(path, image, named, film.place);
}

/// Whether a layer shows an error that is not known yet.
bool lacks_error(const LayerRow* row, const RenderState& state)
{
    const auto* const of = std::get_if<OfFilm>(&row->read);
    return of != nullptr && of->needs_error && state.checks.empty();
}

} // namespace

void write_image_of(const std::filesystem::path& path, const Image& image, const RenderState& state,
                    const Display& display)
{
    if (image_format(path) == ImageFormat::exr)
        write_exr_with_error(path, image, state);
    else
        write_image(path, image, display);
}

WrittenLayers write_layers_of(const std::filesystem::path& path, const LayerChoice& choice,
                              std::span<const LayerImage> surfaces, const Image& image,
                              const RenderState& state)
{
    WrittenLayers out;
    std::vector<LayerImage> layers(surfaces.begin(), surfaces.end());
    for (const LayerRow* row : chosen_layers(choice)) {
        if (lacks_error(row, state))
            out.unknown.push_back(row);
        else if (std::holds_alternative<OfFilm>(row->read))
            layers.push_back(film_layer(*row, image, state.film));
    }
    write_layers(path, choice.view_layer, {image.width, image.height, state.film.place}, layers);
    out.written = layers.size();
    return out;
}

} // namespace hipmap
