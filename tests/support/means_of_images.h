#pragma once

#include "tests/support/mean_luminance.h"
#include "tests/support/render_image.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_scenes.h"

#include <catch2/catch.hpp>

namespace hipmap {

/// Mean luminance of ten passes that do not depend on each other, each of so many samples a pixel.
/// One pilot chooses the radii of all: it takes longer than the pass of a small image.
inline RunningMean means_of(const tiny::ReadyScene& ready, RenderOptions options, int samples)
{
    options.samples = samples;
    RenderStatistics ignored;
    const PassSource source = make_pass_source(*ready.render, options, ignored);
    RunningMean out;
    for (std::uint64_t pass = 0; pass < 10; ++pass)
        out.add(mean_luminance(source.render(pass, {}).images.radiance));
    return out;
}

/// How much noise there may be beside the light, and what has the maps.
struct AgreementLimits {
    double most_noise = 0.01; ///< standard error of the difference over the mean
    Integrator with_maps = Integrator::progressive;
};

/// Checks that images by an integrator with maps and by `path`, each of so many samples a pixel,
/// have the same mean but for probability and a bias below 1 part in 100: estimates blur across
/// facets and close corners.
inline void check_agreement(const tiny::ReadyScene& ready, ImageOptions options, int maps_samples,
                            int paths_samples, const AgreementLimits& limits = {})
{
    options.integrator = Integrator::path;
    const RunningMean paths = means_of(ready, options, paths_samples);
    options.integrator = limits.with_maps;
    const RunningMean maps = means_of(ready, options, maps_samples);
    const double noise = std::hypot(maps.standard_error(), paths.standard_error());
    INFO("maps " << maps.mean() << ", paths " << paths.mean() << ", noise " << noise);
    CHECK(std::abs(maps.mean() - paths.mean()) < 0.01 * paths.mean() + kMostZ * noise);
    CHECK(noise < limits.most_noise * paths.mean());
}

} // namespace hipmap
