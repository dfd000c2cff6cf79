#pragma once

#include "experiments/rivals/rival.h"
#include "tests/support/mean_luminance.h"
#include "tests/support/means_of_images.h"
#include "tests/support/tiny_rooms.h"

namespace hipmap::tiny {

inline RivalSettings small_image(int samples)
{
    RivalSettings out;
    out.width = 12;
    out.height = 8;
    out.samples = samples;
    return out;
}

/// Mean luminance of images of ten seeds.
template <typename Render>
RunningMean means_of_seeds(const ReadyScene& ready, RivalSettings settings, const Render& render)
{
    RunningMean out;
    for (settings.seed = 0; settings.seed < 10; ++settings.seed)
        out.add(mean_luminance(render(*ready.render, settings).image));
    return out;
}

/// Returns the mean of an image by hipmap's path tracer.
inline RunningMean means_of_paths(const ReadyScene& ready, const RivalSettings& settings,
                                  int samples, const LightClasses& light = {})
{
    ImageOptions options;
    options.integrator = Integrator::path;
    options.width = settings.width;
    options.height = settings.height;
    options.filter = PixelFilter::box;
    options.light = light;
    return means_of(ready, options, samples);
}

/// Three standard errors: seeds are fixed, so that a right method passes always.
inline void check_same(const RunningMean& found, const RunningMean& expected, double most_noise)
{
    const double noise = std::hypot(found.standard_error(), expected.standard_error());
    INFO("found " << found.mean() << ", expected " << expected.mean() << ", noise " << noise);
    CHECK(std::abs(found.mean() - expected.mean()) < 3 * noise);
    CHECK(noise < most_noise * expected.mean());
}

/// The inside of a box lit by a point light.
inline Scene box_with_point_light()
{
    Scene scene = box(diffuse({0.7f, 0.5f, 0.3f}));
    ScenePointLight lamp;
    lamp.position = {0.1, 0.3, -0.1};
    lamp.intensity = glm::dvec3(1, 1.5, 2);
    scene.lights.push_back(lamp);
    return scene;
}

} // namespace hipmap::tiny
