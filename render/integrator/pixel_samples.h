#pragma once

#include "common/image/pixel_rect.h"
#include "common/math/part.h"
#include "common/math/random.h"
#include "common/math/sampling.h"
#include "common/rays/camera_ray.h"
#include "render/integrator/eye_path.h"
#include "render/integrator/pass_source.h"
#include "render/integrator/pixel_groups.h"
#include "render/integrator/sample_allocation.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace hipmap {

/// The inputs of the samples of one pass.
struct PictureJob {
    const RenderScene& scene;
    const RenderOptions& options;
    std::uint64_t pass = 0;
    const SampleAllocation& allocation;
    PixelGroups groups = {};  ///< whose samples are finished together
    GlossyRivals rivals = {}; ///< of the samples of seen lights

    /// Returns the index of a pixel of the whole image.
    std::uint64_t index_of(int x, int y) const
    {
        return static_cast<std::uint64_t>(y) * options.width + x;
    }
    std::uint32_t samples(std::uint64_t pixel) const
    {
        return allocation.samples.empty() ? options.samples : allocation.samples[pixel];
    }
    std::uint32_t light_samples(std::uint64_t pixel) const
    {
        const std::uint32_t found = allocation.lights.empty() ? 0 : allocation.lights[pixel];
        // Lights are not clamped, so they need samples of their own.
        return options.clamp > 0 ? std::max(found, samples(pixel)) : found;
    }
};

/// Whether the last of so many images is what clamping took: of a pass with one image or with those
/// by three radii.
template <std::size_t images>
inline constexpr bool has_cut = images == 2 || images == 4;

/// The samples of one eye ray, one for each image of the pass.
template <std::size_t images>
using Samples = std::array<Rgb, images>;

template <std::size_t images>
bool are_finite(const Samples<images>& samples)
{
    return std::ranges::all_of(samples, [](const Rgb& value) { return is_finite(value); });
}

/// Returns the samples with no channel above `most`, their hue kept, and what the first one lost.
template <std::size_t images>
Samples<images + 1> clamp_samples(const Samples<images>& samples, float most)
{
    Samples<images + 1> out{};
    for (std::size_t i = 0; i < images; ++i) {
        const float largest = max_channel(samples[i]);
        out[i] = largest > most ? samples[i] * (most / largest) : samples[i];
    }
    out[images] = samples[0] - out[0];
    return out;
}

/// The sums that samples add to the nine pixels around their own, row by row: values times weights,
/// and weights.
template <std::size_t images>
struct FilteredSamples {
    std::array<Samples<images>, 9> values{};
    std::array<float, 9> weights{};
    std::uint32_t kept = 0; ///< samples

    void add(PixelFilter filter, const glm::vec2& at, const Samples<images>& sample)
    {
        const std::array<float, 3> across = filter_weights(filter, at.x);
        const std::array<float, 3> down = filter_weights(filter, at.y);
        for (std::size_t i = 0; i < 9; ++i) {
            const float weight = across[i % 3] * down[i / 3];
            weights[i] += weight;
            for (std::size_t image = 0; image < images; ++image)
                values[i][image] += weight * sample[image];
        }
        ++kept;
    }
};

/// Returns the random numbers of a pixel's samples.  Passes of a batch share a sequence, and
/// batches stay independent: docs/error.md (15).
inline RandomSequence sample_sequence(const PictureJob& job, RandomStream stream,
                                      std::uint64_t pixel, std::uint32_t samples, std::uint32_t s)
{
    return {job.options.seed, stream, job.pass % kBatches, pixel,
            job.pass / kBatches * samples + s};
}

/// A ray, and where in its pixel it starts, from 0 to 1 on both axes.
struct PixelRay {
    Ray ray;
    glm::vec2 at;
};

/// Returns the ray through a point of the image, in pixels from the top left, and of the lens, in
/// the unit disc.
inline Ray image_ray(const RenderScene& scene, const RenderOptions& options, const glm::vec2& point,
                     const glm::vec2& lens)
{
    const glm::vec2 size(static_cast<float>(options.width), static_cast<float>(options.height));
    return camera_ray(scene.scene.cameras[scene.scene.camera], point / size, size.x / size.y, lens);
}

/// Returns a ray through a random point of the pixel.
inline PixelRay pixel_ray(const PictureJob& job, int x, int y, RandomSequence& random)
{
    const Camera& camera = job.scene.scene.cameras[job.scene.scene.camera];
    const glm::vec2 at = random.next2();
    const glm::vec2 point = glm::vec2(static_cast<float>(x), static_cast<float>(y)) + at;
    const glm::vec2 lens = has_lens(camera) ? sample_disc(random.next2()) : glm::vec2(0.0f);
    return {image_ray(job.scene, job.options, point, lens), at};
}

/// Calls visit(pixel) for a pixel and those of the image up to `reach` away along each axis.
template <typename Visit>
void over_pixels_around(const RenderOptions& image, std::size_t pixel, int reach,
                        const Visit& visit)
{
    const int x = static_cast<int>(pixel) % image.width, y = static_cast<int>(pixel) / image.width;
    for (int v = std::max(0, y - reach); v <= std::min(image.height - 1, y + reach); ++v)
        for (int u = std::max(0, x - reach); u <= std::min(image.width - 1, x + reach); ++u)
            visit(static_cast<std::size_t>(v) * image.width + u);
}

/// Takes the extra samples of directly visible lights; keeps those that are finite.
inline FilteredSamples<1> sample_seen_lights(const PictureJob& job, int x, int y)
{
    const std::uint64_t pixel = job.index_of(x, y);
    const std::uint32_t samples = job.light_samples(pixel);
    FilteredSamples<1> sums;
    for (std::uint32_t s = 0; s < samples; ++s) {
        RandomSequence random = sample_sequence(job, RandomStream::seen_lights, pixel, samples, s);
        const PixelRay from = pixel_ray(job, x, y, random);
        const Rgb seen = trace_seen_lights(job.scene, from.ray, random, job.rivals);
        if (is_finite(seen))
            sums.add(job.options.filter, from.at, {seen});
    }
    return sums;
}

/// Adds the mean of the samples of directly visible lights to that of the others, with the weights
/// of each pixel around.
template <std::size_t images>
void add_seen_lights(const FilteredSamples<1>& lights, FilteredSamples<images>& samples)
{
    for (std::size_t i = 0; i < 9; ++i)
        for (std::size_t image = 0; image < images - has_cut<images> && lights.weights[i] > 0;
             ++image)
            samples.values[i][image] +=
                lights.values[i][0] / lights.weights[i] * samples.weights[i];
}

/// How many images there are before samples are clamped.
template <std::size_t images>
inline constexpr std::size_t traced_images = images - has_cut<images>;

/// A sample of a pixel, before it is clamped and filtered.
template <std::size_t images>
struct TracedSample {
    glm::vec2 at{0.0f}; ///< where in its pixel
    Samples<images> value{};
};

/// Appends the samples of a pixel.  trace(ray, seen, random, scratch): as that of TileTracer.
template <std::size_t images, typename Scratch, typename Trace>
void trace_pixel(const PictureJob& job, const glm::ivec2& at, const Trace& trace, Scratch& scratch,
                 std::vector<TracedSample<images>>& out)
{
    const std::uint64_t pixel = job.index_of(at.x, at.y);
    const std::uint32_t samples = job.samples(pixel);
    const SeenLights seen = job.light_samples(pixel) > 0 ? SeenLights::left_out : SeenLights::added;
    for (std::uint32_t s = 0; s < samples; ++s) {
        RandomSequence random = sample_sequence(job, RandomStream::eye_paths, pixel, samples, s);
        const PixelRay from = pixel_ray(job, at.x, at.y, random);
        out.push_back({from.at, trace(from.ray, seen, random, scratch)});
    }
}

/// The samples of some rows of pixels, pixel by pixel.
template <std::size_t images>
struct TracedRows {
    PixelRect pixels;                  ///< of the image
    std::vector<std::uint32_t> begins; ///< [pixels + 1] of their samples
    std::vector<TracedSample<images>> samples;

    /// Returns which of the samples are those of a pixel.
    Part samples_of(int x, int y) const
    {
        const auto pixel =
            static_cast<std::size_t>((y - pixels.y0) * pixels.width() + x - pixels.x0);
        return {begins[pixel], begins[pixel + 1]};
    }
};

/// Clamps and filters all samples of a pixel, with its seen lights; samples that are not finite are
/// left out with their weights.  All samples of a pixel together weigh one.
template <std::size_t images>
FilteredSamples<images>
filter_pixel(const PictureJob& job, int x, int y,
             std::type_identity_t<std::span<const TracedSample<traced_images<images>>>> samples)
{
    FilteredSamples<images> sums;
    const auto add = [&](const glm::vec2& at, const Samples<images>& value) {
        if (are_finite(value))
            sums.add(job.options.filter, at, value);
    };
    for (const auto& [at, value] : samples)
        if constexpr (has_cut<images>)
            add(at, clamp_samples(value, job.options.clamp));
        else
            add(at, value);
    const auto all = static_cast<float>(samples.size());
    for (std::size_t i = 0; i < 9; ++i) {
        sums.weights[i] /= all;
        for (Rgb& value : sums.values[i])
            value /= all;
    }
    if (job.light_samples(job.index_of(x, y)) > 0)
        add_seen_lights(sample_seen_lights(job, x, y), sums);
    return sums;
}

} // namespace hipmap
