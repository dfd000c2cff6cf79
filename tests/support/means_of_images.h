#pragma once

#include "tests/support/mean_luminance.h"
#include "tests/support/render_image.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_scenes.h"

namespace hipmap {

/// Mean luminance of images by ten seeds, each of so many samples a pixel.
inline RunningMean means_of(const tiny::ReadyScene& ready, ImageOptions options, int samples)
{
    RunningMean out;
    options.samples = samples;
    for (options.seed = 0; options.seed < 10; ++options.seed)
        out.add(mean_luminance(render_image(*ready.render, options, {}).image));
    return out;
}

} // namespace hipmap
