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

/// Means by maps and by paths, and the standard error of their difference.
struct MapsAndPaths {
    RunningMean maps, paths;
    double noise = 0;
};

/// By an integrator with maps and by `path`, each of so many samples a pixel.
inline MapsAndPaths by_maps_and_paths(const tiny::ReadyScene& ready, ImageOptions options, int maps,
                                      int paths, Integrator with_maps = Integrator::progressive)
{
    MapsAndPaths out;
    options.integrator = Integrator::path;
    out.paths = means_of(ready, options, paths);
    options.integrator = with_maps;
    out.maps = means_of(ready, options, maps);
    out.noise = std::hypot(out.maps.standard_error(), out.paths.standard_error());
    return out;
}

} // namespace hipmap
