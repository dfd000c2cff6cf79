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

/// How many gather rays share their ends, at most; a pixel has one for each of its samples.
inline constexpr int kSharing = 8;

/// Pixels from one to the next of those that share: between them lie pixels that share other ends,
/// so that the filter of the image takes the mean over both.
inline constexpr int kApart = 2;

/// Returns the groups of a pass whose samples share what their gather rays find,
/// docs/light_transport.md (51).  They lie elsewhere from pass to pass, so that no edge shows.
inline PixelGroups sharing_groups(std::uint64_t pass)
{
    constexpr int kColumns = 4, kRows = kSharing / kColumns;
    constexpr int kAcross = kColumns * kApart, kDown = kRows * kApart;
    return {.across = kAcross,
            .down = kDown,
            .left = kAcross / 2 * static_cast<int>(pass % 2),
            .above = kDown / 2 * static_cast<int>(pass / 2 % 2)};
}

} // namespace hipmap
