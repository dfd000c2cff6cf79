#include "render/integrator/long_paths.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace hipmap {

namespace {

/// Samples of all pixels, and of those up to kReach away from a long path.
constexpr Part kFirst{0, 8}, kFurther{8, 64};
constexpr int kReach = 3;

std::vector<FarLight> suns_of(const RenderScene& scene)
{
    std::vector<FarLight> out;
    for (const Light& light : scene.lights.lights)
        if (const std::optional<FarLight> sun = far_light(light); sun && sun->second > 0)
            out.push_back(*sun);
    return out;
}

bool has_any(const LongPaths& paths)
{
    return paths.variance > 0;
}

LongPaths sum_of(const PictureJob& job, std::span<const FarLight> suns, std::size_t pixel,
                 const Part& samples)
{
    const int width = job.options.width;
    const int x = static_cast<int>(pixel) % width, y = static_cast<int>(pixel) / width;
    LongPaths sum;
    for (std::size_t s = samples.begin; s < samples.end; ++s) {
        RandomSequence random = sample_sequence(job, RandomStream::seen_lights, pixel,
                                                static_cast<std::uint32_t>(kFurther.end),
                                                static_cast<std::uint32_t>(s));
        const Ray ray = pixel_ray(job, x, y, random).ray;
        const LongPaths sample = trace_long_paths(job.scene, suns, ray, random);
        if (std::isfinite(sample.variance))
            sum += sample;
    }
    return sum;
}

} // namespace

std::vector<LongPaths> measure_long_paths(const PictureJob& job, const PilotTeam& team)
{
    const std::vector<FarLight> suns = suns_of(job.scene);
    if (suns.empty())
        return {};
    const auto width = static_cast<std::size_t>(job.options.width);
    const Part rows = team.part(static_cast<std::size_t>(job.options.height));
    const Part pixels{rows.begin * width, rows.end * width};
    std::vector<LongPaths> own(pixels.size());
    tbb::parallel_for(pixels.begin, pixels.end,
                      [&](std::size_t i) { own[i - pixels.begin] = sum_of(job, suns, i, kFirst); });
    const std::vector<LongPaths> first = joined(team, own);
    std::vector<std::size_t> samples(first.size(), kFirst.size());
    for (std::size_t i = 0; i < first.size(); ++i)
        if (has_any(first[i]))
            over_pixels_around(job.options, i, kReach,
                               [&](std::size_t at) { samples[at] = kFurther.end; });
    if (std::ranges::none_of(first, has_any))
        return {};
    tbb::parallel_for(pixels.begin, pixels.end, [&](std::size_t i) {
        own[i - pixels.begin] += sum_of(job, suns, i, {kFirst.end, samples[i]});
    });
    const std::vector<LongPaths> sums = joined(team, std::move(own));
    std::vector<LongPaths> out(sums.size());
    for (std::size_t i = 0; i < out.size(); ++i) {
        std::size_t taken = 0;
        over_pixels_around(job.options, i, 1, [&](std::size_t at) {
            out[i] += sums[at];
            taken += samples[at];
        });
        out[i] /= static_cast<float>(taken);
    }
    return out;
}

} // namespace hipmap
