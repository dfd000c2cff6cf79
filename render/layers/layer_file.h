#pragma once

#include "common/image/exr_file.h"
#include "render/layers/layer.h"

#include <filesystem>
#include <span>
#include <string>

namespace hipmap {

/// The layers to write, and their place in Blender.
struct LayerChoice {
    std::vector<const LayerRow*> rows;    ///< empty: all
    std::string view_layer = "ViewLayer"; ///< Blender's first has this name
};

/// Returns the layers that a list such as "combined,depth" names, each once.  Throws InputError,
/// listing the names, for any other.
std::vector<const LayerRow*> parse_layers(std::string_view text);

/// Returns the names of layers as parse_layers reads them.
std::string text_of(std::span<const LayerRow* const> rows);

/// Returns the chosen layers, in the order of the table if all are chosen.
std::vector<const LayerRow*> chosen_layers(const LayerChoice& choice);

/// Returns a layer of the rendered image and its film.  row: OfFilm.
LayerImage film_layer(const LayerRow& row, const Image& image, const Film& film);

/// Writes layers of the pixels of a window as a multi-layer .exr file, whose channels have
/// Blender's names, such as "ViewLayer.Depth.Z".  Throws InputError if the file cannot be written.
void write_layers(const std::filesystem::path& path, const std::string& view_layer,
                  const ExrWindow& window, std::span<const LayerImage> layers);

} // namespace hipmap
