#include "render/integrator/light_sample_allocation.h"

#include "render/integrator/long_paths.h"
#include "render/integrator/pixel_samples.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>

namespace hipmap {

namespace {

constexpr std::uint32_t kLeastLightSamples = 16;
constexpr std::uint32_t kPilotSamples = 8;

/// The ratio of the deviation of lights to their mean below which they count as even.
constexpr float kEven = 0.05f;

/// The moments of some samples.
struct Moments {
    float mean = 0, variance = 0;
};

Moments moments_of(const PictureJob& job, int x, int y)
{
    const std::uint64_t pixel = job.index_of(x, y);
    double sum = 0, squares = 0;
    for (std::uint32_t s = 0; s < kPilotSamples; ++s) {
        RandomSequence random =
            sample_sequence(job, RandomStream::seen_lights, pixel, kPilotSamples, s);
        const Ray ray = pixel_ray(job, x, y, random).ray;
        const Rgb seen = trace_seen_lights(job.scene, ray, random, job.rivals);
        const double light = is_finite(seen) ? double{max_channel(seen)} : 0.0;
        sum += light;
        squares += light * light;
    }
    const double mean = sum / kPilotSamples;
    const double variance = (squares - sum * mean) / (kPilotSamples - 1);
    return {static_cast<float>(mean), static_cast<float>(std::max(variance, 0.0))};
}

/// Returns the mean moments of the pixel and of those around it.
Moments around(const std::vector<Moments>& moments, const RenderOptions& image, std::size_t pixel)
{
    Moments sum;
    float count = 0;
    over_pixels_around(image, pixel, 1, [&](std::size_t near) {
        sum.mean += moments[near].mean;
        sum.variance += moments[near].variance;
        ++count;
    });
    return {sum.mean / count, sum.variance / count};
}

} // namespace

double mean_of(const LightNoise& noise)
{
    const double sum = std::reduce(noise.mean.begin(), noise.mean.end(), 0.0);
    return noise.mean.empty() ? 0 : sum / static_cast<double>(noise.mean.size());
}

LightNoise measure_light_noise(const RenderScene& scene, const RenderOptions& options,
                               const PilotTeam& team, const GlossyRivals& rivals)
{
    const int width = options.width;
    const PictureJob job{
        .scene = scene, .options = options, .pass = kPilotPass, .allocation = {}, .rivals = rivals};
    const Part rows = team.part(static_cast<std::size_t>(options.height));
    std::vector<Moments> own(rows.size() * static_cast<std::size_t>(width));
    tbb::parallel_for(rows.begin, rows.end, [&](std::size_t y) {
        for (int x = 0; x < width; ++x)
            own[(y - rows.begin) * width + x] = moments_of(job, x, static_cast<int>(y));
    });
    const std::vector<Moments> moments = joined(team, std::move(own));
    LightNoise out;
    out.long_paths = measure_long_paths(job, team);
    if (out.long_paths.empty() &&
        std::ranges::all_of(moments, [](const Moments& at) { return at.mean == 0; }))
        return {};
    for (std::size_t pixel = 0; pixel < moments.size(); ++pixel) {
        const Moments all = around(moments, options, pixel);
        out.mean.push_back(all.mean);
        out.variance.push_back(all.variance);
    }
    return out;
}

Image measure_emissive_noise(const RenderScene& scene, const RenderOptions& options,
                             const PilotTeam& team)
{
    if (scene.lights.faces.empty())
        return {};
    const PictureJob job{scene, options, kPilotPass, {}};
    const auto width = static_cast<std::size_t>(options.width);
    const Part rows = team.part(static_cast<std::size_t>(options.height));
    std::vector<Rgb> own(rows.size() * width);
    tbb::parallel_for(rows.begin * width, rows.end * width, [&](std::size_t pixel) {
        RandomSequence random = sample_sequence(job, RandomStream::emissive_faces, pixel, 1, 0);
        const int x = static_cast<int>(pixel % width), y = static_cast<int>(pixel / width);
        const Ray ray = pixel_ray(job, x, y, random).ray;
        own[pixel - rows.begin * width] = trace_emissive_difference(scene, ray, random);
    });
    Image out(options.width, options.height);
    out.pixels = joined(team, std::move(own));
    return out;
}

std::vector<std::uint16_t> allocate_light_samples(const LightNoise& noise, std::uint32_t samples)
{
    const auto taken =
        static_cast<std::uint16_t>(std::min(65535u, std::max(kLeastLightSamples, samples)));
    std::vector<std::uint16_t> out(noise.mean.size());
    for (std::size_t i = 0; i < out.size(); ++i) {
        const float even = kEven * noise.mean[i];
        out[i] = noise.variance[i] > even * even ? taken : 0;
    }
    return out;
}

} // namespace hipmap
