#pragma once

#include "common/image/pixel_rect.h"
#include "render/film/pass_set.h"

#include <optional>
#include <vector>

namespace hipmap {

/// Pixels of a film and the passes that all of them hold.
struct FilmPart {
    PixelRect pixels; ///< never empty
    PassSet passes;   ///< never empty
    bool operator==(const FilmPart&) const = default;
};

/// A pass that two films hold of the same pixels.
struct CommonPass {
    PixelRect pixels;
    std::uint64_t pass = 0;
};

/// Returns the pixels that both rectangles hold, maybe none.
PixelRect common_pixels(const PixelRect& a, const PixelRect& b);

/// Returns a pass that parts of both lists hold of common pixels; none if there is none.
std::optional<CommonPass> common_pass(const std::vector<FilmPart>& a,
                                      const std::vector<FilmPart>& b);

/// Returns parts without common pixels that hold the same passes of each pixel.  parts: may have
/// common pixels, but no common passes of these.  The result depends on what each pixel holds
/// alone, not on the order or shape of `parts`, and tiles that fill a rectangle with the same
/// passes become one part.  Ordered from the top, then from the left.
std::vector<FilmPart> joined_parts(const std::vector<FilmPart>& parts);

/// Returns whether parts are as joined_parts returns them, within an image of this size.
bool are_valid(const std::vector<FilmPart>& parts, int width, int height);

/// Returns what pixels lack of passes, as joined_parts would.
/// held: as joined_parts returns them.
std::vector<FilmPart> missing_parts(const std::vector<FilmPart>& held, const FilmPart& wanted);

} // namespace hipmap
