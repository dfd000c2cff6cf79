#include "render/integrator/light_sample_allocation.h"

#include "render/integrator/pixel_samples.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>

namespace hipmap {

namespace {

constexpr std::uint32_t kLeastLightSamples = 16;
constexpr std::uint16_t kPilotSamples = 8;

/// The ratio of the greatest difference of lights to their mean below which they count as even.
constexpr float kEven = 0.1f;

/// The range of the light in some samples, by its brightest channel.
struct Range {
    float least = std::numeric_limits<float>::infinity(), most = 0, sum = 0;

    void add(const Range& other)
    {
        least = std::min(least, other.least);
        most = std::max(most, other.most);
        sum += other.sum;
    }
};

Range range_of(const PictureJob& job, int x, int y)
{
    const std::uint64_t pixel = static_cast<std::uint64_t>(y) * job.options.width + x;
    Range out;
    for (std::uint32_t s = 0; s < kPilotSamples; ++s) {
        RandomSequence random =
            sample_sequence(job, RandomStream::seen_lights, pixel, kPilotSamples, s);
        const Ray ray = pixel_ray(job, x, y, random).ray;
        const Rgb seen = trace_seen_lights(job.scene, ray, random);
        const float light = is_finite(seen) ? max_channel(seen) : 0.0f;
        out.add({light, light, light});
    }
    return out;
}

/// Returns whether the lights of the pixel and its neighbours differ; few samples of a pixel alone
/// may miss that.
bool uneven_around(const std::vector<Range>& ranges, int x, int y, int width, int height)
{
    Range all;
    float count = 0;
    for (int v = std::max(0, y - 1); v <= std::min(height - 1, y + 1); ++v)
        for (int u = std::max(0, x - 1); u <= std::min(width - 1, x + 1); ++u) {
            all.add(ranges[static_cast<std::size_t>(v) * width + u]);
            count += kPilotSamples;
        }
    return all.most - all.least > kEven * all.sum / count;
}

} // namespace

std::vector<std::uint16_t> allocate_light_samples(const RenderScene& scene,
                                                  const RenderOptions& options)
{
    if (!can_be_met(scene.lights))
        return {};
    const int width = options.width, height = options.height;
    const PictureJob job{scene, options, kPilotPass, {}};
    std::vector<Range> ranges(static_cast<std::size_t>(width) * height);
    tbb::parallel_for(0, height, [&](int y) {
        for (int x = 0; x < width; ++x)
            ranges[static_cast<std::size_t>(y) * width + x] = range_of(job, x, y);
    });
    std::vector<std::uint16_t> out(ranges.size(), 0);
    const auto samples =
        static_cast<std::uint16_t>(std::min(65535u, std::max(kLeastLightSamples, options.samples)));
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            if (uneven_around(ranges, x, y, width, height))
                out[static_cast<std::size_t>(y) * width + x] = samples;
    return out;
}

} // namespace hipmap
