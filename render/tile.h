#pragma once

#include "common/command_line/option_fields.h"
#include "common/image/pixel_rect.h"

#include <optional>

namespace hipmap {

/// One tile of a grid that divides an image, as on the command line: "NUMBER/COLUMNSxROWS".
struct Tile {
    int number = 0; ///< from 0 at the top left, row by row
    int columns = 1, rows = 1;
};

/// Makes an option field for a tile.
OptionField tile_field(std::optional<Tile>& into);

/// Returns the pixels of a tile of these pixels.  All tiles of a grid together hold each pixel
/// once.  Throws InputError if there are more columns or rows than pixels.
PixelRect pixels_of(const Tile& tile, const PixelRect& image);

} // namespace hipmap
