#pragma once

#include "common/image/image.h"
#include "render/integrator/pilot_team.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <functional>
#include <vector>

namespace hipmap {

struct RenderOptions;

/// What an image will be like, long before its first pass is whole: one pixel of each block of the
/// pixels to render.
struct CoarseImage {
    Image image;     ///< [blocks]
    int block = 1;   ///< pixels across a block; those at the right and at the bottom may be cut
    double pass = 0; ///< s that a pass may take, from what this image took
};

/// The callbacks of a caller while an integrator finds what its passes share.
struct PilotControl {
    const std::atomic<bool>* stop = nullptr; ///< true: return soon; no pass may be rendered then
    std::function<void(const CoarseImage&)> coarse; ///< called once, or not at all; may be empty
    PilotTeam team;

    bool stopped() const { return stop != nullptr && stop->load(); }
};

/// Returns whether a process of the team was told to stop.
inline bool stopped_together(const PilotControl& pilots)
{
    const std::vector<std::uint8_t> stopped =
        joined(pilots.team, std::vector{std::uint8_t{pilots.stopped()}});
    return std::ranges::find(stopped, 1) != stopped.end();
}

/// Returns the pixels across a block, so that a coarse image costs little beside a pass and at most
/// as much as a small image.
int coarse_block(const RenderOptions& options);

/// Fills pixels of an image by those of the coarse one, interpolated linearly.  kept: [pixels]
/// whether the pixel is to stay as it is.
void fill_by_coarse(const CoarseImage& coarse, const std::vector<std::uint8_t>& kept, Image& image);

} // namespace hipmap
