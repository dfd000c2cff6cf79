#pragma once

#include "common/math/random.h"
#include "common/math/sampling.h"
#include "common/rays/camera_ray.h"
#include "common/stopwatch.h"
#include "render/integrator/eye_path.h"
#include "render/integrator/pass_source.h"
#include "render/integrator/sample_allotment.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <mutex>

namespace hipmap {

/// What the samples of one pass are taken by.
struct PictureJob {
    const RenderScene& scene;
    const RenderOptions& options;
    std::uint64_t pass = 0;
    const SampleAllotment& allotment;

    std::uint32_t samples(std::uint64_t pixel) const
    {
        return allotment.samples.empty() ? options.samples : allotment.samples[pixel];
    }
    std::uint32_t light_samples(std::uint64_t pixel) const
    {
        return allotment.lights.empty() ? 0 : allotment.lights[pixel];
    }
};

inline constexpr int kTile = 16;

inline bool is_finite_rgb(const Rgb& value)
{
    return is_finite(value);
}

/// Samples of one eye ray, by what each image of the pass is to have.
template <std::size_t images>
using Samples = std::array<Rgb, images>;

/// Passes of a batch share a sequence, and batches stay independent: docs/error.md (15).
inline RandomSequence sample_sequence(const PictureJob& job, RandomStream stream,
                                      std::uint64_t pixel, std::uint32_t samples, std::uint32_t s)
{
    return {job.options.seed, stream, job.pass % kBatches, pixel,
            job.pass / kBatches * samples + s};
}

/// A ray through somewhere in the pixel.
inline Ray pixel_ray(const PictureJob& job, int x, int y, RandomSequence& random)
{
    const glm::vec2 size(static_cast<float>(job.options.width),
                         static_cast<float>(job.options.height));
    const Camera& camera = job.scene.scene.cameras[job.scene.scene.camera];
    const glm::vec2 at =
        (glm::vec2(static_cast<float>(x), static_cast<float>(y)) + random.next2()) / size;
    const glm::vec2 lens = has_lens(camera) ? sample_disc(random.next2()) : glm::vec2(0.0f);
    return camera_ray(camera, at, size.x / size.y, lens);
}

/// The mean of the pixel's samples of seen lights alone that are finite.
inline Rgb sample_seen_lights(const PictureJob& job, int x, int y)
{
    const std::uint64_t pixel = static_cast<std::uint64_t>(y) * job.options.width + x;
    const std::uint32_t samples = job.light_samples(pixel);
    Rgb sum(0);
    std::uint32_t kept = 0;
    for (std::uint32_t s = 0; s < samples; ++s) {
        RandomSequence random = sample_sequence(job, RandomStream::seen_lights, pixel, samples, s);
        const Ray ray = pixel_ray(job, x, y, random);
        const Rgb seen = trace_seen_lights(job.scene, ray, random);
        if (!is_finite(seen))
            continue;
        sum += seen;
        ++kept;
    }
    return sum / static_cast<float>(std::max(1u, kept));
}

/// Takes the samples of a pixel: the mean of those that are finite, one for each image; `kept` is
/// their number.
template <std::size_t images, typename Trace>
Samples<images> sample_pixel(const PictureJob& job, int x, int y, const Trace& trace,
                             std::uint32_t& kept)
{
    const std::uint64_t pixel = static_cast<std::uint64_t>(y) * job.options.width + x;
    const std::uint32_t samples = job.samples(pixel);
    const bool apart = job.light_samples(pixel) > 0;
    Samples<images> sum{};
    kept = 0;
    for (std::uint32_t s = 0; s < samples; ++s) {
        RandomSequence random = sample_sequence(job, RandomStream::eye_paths, pixel, samples, s);
        const Ray ray = pixel_ray(job, x, y, random);
        const Samples<images> sample =
            trace(ray, apart ? SeenLights::left_out : SeenLights::added, random);
        if (!std::all_of(sample.begin(), sample.end(), is_finite_rgb))
            continue;
        for (std::size_t i = 0; i < images; ++i)
            sum[i] += sample[i];
        ++kept;
    }
    const Rgb lights = apart ? sample_seen_lights(job, x, y) : Rgb(0);
    for (Rgb& mean : sum)
        mean = mean / static_cast<float>(std::max(1u, kept)) + lights;
    return sum;
}

/// A tile of 16 x 16 pixels: writes their means; returns the samples dropped because they were not
/// finite.
template <std::size_t images, typename Trace>
std::uint64_t render_tile(const PictureJob& job, int tile, PassImages& out, const Trace& trace)
{
    const int width = job.options.width, height = job.options.height;
    const int across = (width + kTile - 1) / kTile;
    const int x0 = tile % across * kTile, y0 = tile / across * kTile;
    std::uint64_t dropped = 0;
    for (int y = y0; y < std::min(y0 + kTile, height); ++y)
        for (int x = x0; x < std::min(x0 + kTile, width); ++x) {
            std::uint32_t kept = 0;
            const Samples<images> mean = sample_pixel<images>(job, x, y, trace, kept);
            const std::size_t pixel = static_cast<std::size_t>(y) * width + x;
            dropped += job.samples(pixel) - kept;
            if (kept == 0 || !std::all_of(mean.begin(), mean.end(), is_finite_rgb))
                continue;
            out.radiance.at(x, y) = mean[0];
            if constexpr (images == 3) {
                out.narrow.at(x, y) = mean[1];
                out.narrower.at(x, y) = mean[2];
            }
            out.kept[pixel] = 1;
        }
    return dropped;
}

/// Fills the images of a pass tile by tile, in parallel.  `trace(ray, seen, random, scratch)` gives
/// the Samples of a ray; `count(scratch)` hears what the scratch of a tile has counted, one at a
/// time. A pixel without a finite sample, or of a tile that a stop left out, is not kept.  Adds
/// passes, samples dropped and time to the statistics.
template <std::size_t images, typename Scratch, typename Trace, typename Count>
RenderedPass render_tiles(const PictureJob& job, const PassControl& control,
                          RenderStatistics& statistics, const Trace& trace, const Count& count)
{
    static_assert(images == 1 || images == 3);
    const Stopwatch watch;
    RenderedPass out;
    const int width = job.options.width, height = job.options.height;
    out.images.radiance = Image(width, height);
    if (images == 3)
        out.images.narrow = out.images.narrower = out.images.radiance;
    out.images.kept.assign(out.images.radiance.pixels.size(), 0);
    const int tiles = ((width + kTile - 1) / kTile) * ((height + kTile - 1) / kTile);
    std::mutex mutex;
    int done = 0;
    tbb::parallel_for(0, tiles, [&](int tile) {
        if (control.stop != nullptr && control.stop->load())
            return;
        Scratch scratch;
        const std::uint64_t lost = render_tile<images>(
            job, tile, out.images, [&](const Ray& ray, SeenLights seen, RandomSequence& random) {
                return trace(ray, seen, random, scratch);
            });
        const std::lock_guard lock(mutex);
        count(scratch);
        statistics.dropped_samples += lost;
        out.whole = ++done == tiles;
        if (control.progress)
            control.progress(static_cast<double>(done) / tiles);
    });
    statistics.passes += out.whole ? 1 : 0;
    statistics.seconds_image += watch.seconds();
    statistics.processor_image += watch.processor_seconds();
    return out;
}

} // namespace hipmap
