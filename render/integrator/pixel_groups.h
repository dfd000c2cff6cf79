#pragma once

#include "common/image/pixel_rect.h"

#include <cstdint>

namespace hipmap {

/// Neighbouring pixels whose samples are finished together: rectangles of a grid that is laid over
/// the image, cut where tiles end.
struct PixelGroups {
    int across = 1, down = 1; ///< pixels of a group
    int left = 0, above = 0;  ///< pixels by which the first groups reach out of the image

    int begin_x(int x) const { return x - (x + left) % across; }
    int begin_y(int y) const { return y - (y + above) % down; }
};

/// Returns the groups of a pass whose samples share what their gather rays find,
/// docs/light_transport.md (51).  They lie elsewhere from pass to pass, so that no edge shows.
inline PixelGroups sharing_groups(std::uint64_t pass)
{
    return {.across = 8,
            .down = 4,
            .left = static_cast<int>(4 * (pass % 2)),
            .above = static_cast<int>(2 * (pass / 2 % 2))};
}

} // namespace hipmap
