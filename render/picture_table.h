#pragma once

#include "common/image/legend.h"
#include "render/film/render_state.h"

#include <filesystem>
#include <span>
#include <vector>

namespace hipmap {

/// A picture in false colour.
struct FalseColour {
    Image image; ///< display values
    std::vector<LegendEntry> legend;
};

/// What `render` and `render merge` can show of an image beside its radiance, as a .png of its own.
struct PictureRow {
    const char* option;  ///< that asks for it
    const char* help;    ///< of the option
    const char* lacking; ///< what an image needs of which nothing is known
    bool (*is_known)(const RenderState& state);
    FalseColour (*draw)(const RenderState& state); ///< of a state of which it is known
};

/// Returns every picture.
std::span<const PictureRow> picture_rows();

/// A picture that was asked for.
struct RequestedPicture {
    const PictureRow* row;
    std::filesystem::path path;
};

/// Returns the pictures asked for, in the order of the rows.  paths: by row; empty: it was not
/// asked for.
std::vector<RequestedPicture> requested_pictures(const std::vector<std::filesystem::path>& paths);

/// Returns those of them of which something is known.
std::vector<RequestedPicture> known_pictures(const std::vector<std::filesystem::path>& paths,
                                             const RenderState& state);

/// Writes a picture of a state of which it is known, with its legend.  Throws InputError if the
/// file cannot be written.
LegendedPicture write_picture(const RequestedPicture& picture, const RenderState& state);

} // namespace hipmap
