#pragma once

#include "common/math/random.h"
#include "common/rays/camera_ray.h"
#include "experiments/rivals/rival.h"

#include <tbb/parallel_for.h>

namespace hipmap {

/// Returns the ray through a point of the image, in pixels from the top left.
inline Ray ray_through(const RenderScene& scene, const RivalSettings& settings,
                       const glm::vec2& point)
{
    const glm::vec2 size(settings.width, settings.height);
    return camera_ray(scene.scene.cameras[scene.scene.camera], point / size, size.x / size.y);
}

/// Returns the random numbers of a sample of a pixel.
inline RandomSequence pixel_sequence(const RivalSettings& settings, int x, int y, int sample)
{
    const auto pixel = static_cast<std::uint64_t>(y) * settings.width + x;
    return {settings.seed, RandomStream::eye_paths, 0, pixel, static_cast<std::uint64_t>(sample)};
}

/// Renders the mean of the samples of each pixel of a row (box filter); a sample that is not finite
/// counts zero.  trace(ray, random) -> Rgb.
template <typename Trace>
void render_row(const RenderScene& scene, const RivalSettings& settings, int y, const Trace& trace,
                Image& out)
{
    for (int x = 0; x < settings.width; ++x)
        for (int s = 0; s < settings.samples; ++s) {
            RandomSequence random = pixel_sequence(settings, x, y, s);
            const glm::vec2 at = glm::vec2(x, y) + random.next2();
            const Rgb found = trace(ray_through(scene, settings, at), random);
            if (is_finite(found))
                out.at(x, y) += found / static_cast<float>(settings.samples);
        }
}

/// Renders all rows in parallel.  trace: thread-safe.
template <typename Trace>
Image render_pixels(const RenderScene& scene, const RivalSettings& settings, const Trace& trace)
{
    Image out(settings.width, settings.height);
    tbb::parallel_for(0, settings.height,
                      [&](int y) { render_row(scene, settings, y, trace, out); });
    return out;
}

} // namespace hipmap
