#pragma once

#include "common/image/write_image.h"
#include "render/film/render_state.h"
#include "render/layers/layer_file.h"

#include <filesystem>
#include <span>
#include <vector>

namespace hipmap {

/// Writes the image of a state in the format of the suffix of `path`.  An .exr file also holds the
/// layers of error_layers if the error is known.  Throws InputError as write_image.
void write_image_of(const std::filesystem::path& path, const Image& image, const RenderState& state,
                    const Display& display);

/// The layers of a file that was written.
struct WrittenLayers {
    std::size_t written = 0;
    std::vector<const LayerRow*> unknown; ///< left out: they show an error that is not known yet
};

/// Writes the chosen layers as one .exr file.  surfaces: those that surface_layers returns for the
/// choice.  image: of `state`.  Throws InputError if the file cannot be written.
WrittenLayers write_layers_of(const std::filesystem::path& path, const LayerChoice& choice,
                              std::span<const LayerImage> surfaces, const Image& image,
                              const RenderState& state);

} // namespace hipmap
