#pragma once

#include "render/film/film.h"
#include "render/shading/interaction.h"

#include <string_view>
#include <variant>
#include <vector>

namespace hipmap {

/// The first surface that a camera ray meets.
struct FirstSurface {
    const RenderScene& scene;
    Interaction at;
};

/// Reads up to four channels of a layer; those that the layer lacks are ignored.
using SurfaceReader = glm::vec4 (*)(const FirstSurface& surface);

/// A layer of the rendered image and its film, known after two passes if it `needs_error`.  A
/// fourth channel is 1.
struct OfFilm {
    Image (*read)(const Image& image, const Film& film);
    bool needs_error = false;
};

/// A layer of the surface behind the middle of a pixel, seen through the middle of the lens: for
/// values whose mean means nothing.
struct OfCentre {
    SurfaceReader read;
    float nothing = 0; ///< the value where no surface is
};

/// A layer of surfaces, averaged over the pixel by the pixel filter and over the lens; 0 where no
/// surface is.
struct OfMean {
    SurfaceReader read;
};

using LayerReader = std::variant<OfFilm, OfCentre, OfMean>;

/// A layer of an image, which Blender calls a render pass.  layer_table.cpp has all of them.
struct LayerRow {
    std::string_view name;     ///< on the command line, "depth"
    std::string_view pass;     ///< in Blender, "Depth"
    std::string_view channels; ///< in Blender, a letter each: "Z", "RGBA"
    std::string_view help;     ///< what its values are
    LayerReader read;
};

/// The values of a layer: [pixels][channels], rows from the top.
struct LayerImage {
    const LayerRow* row = nullptr;
    std::vector<float> values;
};

} // namespace hipmap
