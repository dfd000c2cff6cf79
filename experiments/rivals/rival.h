#pragma once

#include "common/image/image.h"
#include "common/stopwatch.h"
#include "render/shading/render_scene.h"

#include <cstdint>

namespace hipmap {

/// The inputs of every rival.  Each reads what its row in methods.cpp names.
struct RivalSettings {
    int width = 256;
    int height = 256;
    int samples = 4;              ///< eye paths of a pixel
    std::uint64_t seed = 0;       ///< images of different seeds are independent
    std::uint64_t cells = 20'000; ///< about as many cells on all faces together
    std::uint64_t rays = 500'000; ///< rays or light paths that carry light to the cells
    int directions = 256;         ///< rays that sample the hemisphere of a cache record
    float tolerance = 0.3f;       ///< a of Ward et al. 1988: the largest error of a cache record
    int views = 6;                ///< cameras of a light field along each side of its window
    float window = 0.05f;         ///< side of that window, in scene units
};

/// What a rival made.
struct RivalImage {
    Image image;              ///< W/(m2 sr)
    Spent prepared;           ///< time for what other views of the scene could use again
    Spent rendered;           ///< time for this view
    std::uint64_t stored = 0; ///< bytes of what was prepared
};

} // namespace hipmap
