#pragma once

#include "render/film/film.h"

namespace hipmap {

/// Cuts a tile out of a whole film, pixel by pixel.
inline Film film_tile(const Film& whole, const PixelRect& pixels)
{
    const auto holds = [&](int x, int y) {
        return x >= pixels.x0 && x < pixels.x1 && y >= pixels.y0 && y < pixels.y1;
    };
    Film tile = whole;
    tile.width = pixels.width();
    tile.height = pixels.height();
    tile.place = {pixels.x0, pixels.y0, whole.width, whole.height};
    for (std::vector<std::int64_t> Film::*sums :
         {&Film::radiance, &Film::narrow, &Film::narrower, &Film::cut}) {
        (tile.*sums).clear();
        for (std::size_t i = 0; i < (whole.*sums).size(); ++i) {
            const int pixel = static_cast<int>(i / 3 % whole.pixel_count());
            if (holds(pixel % whole.width, pixel / whole.width))
                (tile.*sums).push_back((whole.*sums)[i]);
        }
    }
    tile.lost.clear();
    for (const auto& [key, passes] : whole.lost) {
        const int pixel = static_cast<int>(key / kBatches);
        const int x = pixel % whole.width, y = pixel / whole.width;
        const int at = (y - pixels.y0) * tile.width + x - pixels.x0;
        if (holds(x, y))
            tile.lost[static_cast<std::uint64_t>(at) * kBatches + key % kBatches] = passes;
    }
    return tile;
}

} // namespace hipmap
