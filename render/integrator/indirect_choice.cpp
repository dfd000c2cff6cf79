#include "render/integrator/indirect_choice.h"

#include "render/integrator/path_tracer.h"
#include "render/integrator/pixel_samples.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace hipmap {

namespace {

/// The most pixels across the pilot's images.
constexpr int kPilotSide = 160;

/// docs/light_transport.md (50)
constexpr double kMostForPaths = 2.6;
constexpr double kCausticCost = 1.5;

/// Where fewer of the final-gather rays lead to light, paths may miss what photons show.
constexpr double kLeastLit = 0.25;

/// Two pairs of paths of a pixel.
struct PilotPixel {
    Rgb first, second; ///< radiance of one path of each
    Rgb behind;        ///< what the paths of one pair differ by
    int rays = 0, ends = 0, lit = 0;
};

PilotPixel pilot_pixel(const RenderScene& scene, const RenderOptions& options, std::uint64_t pixel)
{
    const int x = static_cast<int>(pixel % static_cast<std::uint64_t>(options.width));
    const int y = static_cast<int>(pixel / static_cast<std::uint64_t>(options.width));
    PathPair pairs[2];
    PilotPixel out;
    for (std::uint64_t s = 0; s < 2; ++s) {
        const PictureJob job{scene, options, kPilotPass - s, {}}; // of a sequence of its own
        RandomSequence random = sample_sequence(job, RandomStream::eye_paths, pixel, 1, 0);
        const Ray ray = pixel_ray(job, x, y, random).ray;
        pairs[s] = trace_path_pair(scene, ray, random, {.caustic = false});
        out.rays += 1 + pairs[s].depth;
        out.ends += pairs[s].ends ? 1 : 0;
        out.lit += pairs[s].ends && pairs[s].finds ? 1 : 0;
    }
    out.first = pairs[0].first;
    out.second = pairs[1].first;
    out.behind = pairs[0].first - pairs[0].second;
    return out;
}

/// What paths over the image show.
struct PilotPaths {
    double variance = 0; ///< of a path
    double behind = 0;   ///< the part of it that is made behind the ends of final-gather rays
    double rays = 0;     ///< of a path, on average
    double lit = 1;      ///< share of those ends that lead to light
};

/// Returns the options of an image of the same view with at most kPilotSide pixels across.
RenderOptions small_options(RenderOptions options)
{
    const double part =
        std::min(1.0, kPilotSide / static_cast<double>(std::max(options.width, options.height)));
    options.width = std::max(1, static_cast<int>(options.width * part));
    options.height = std::max(1, static_cast<int>(options.height * part));
    return options;
}

PilotPaths describe(const std::vector<PilotPixel>& pixels, int width, int height)
{
    Image first(width, height), second = first, between = first, behind = first;
    double rays = 0, ends = 0, lit = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const PilotPixel& pixel = pixels[i];
        first.pixels[i] = pixel.first;
        second.pixels[i] = pixel.second;
        between.pixels[i] = pixel.first - pixel.second;
        behind.pixels[i] = pixel.behind;
        rays += pixel.rays;
        ends += pixel.ends;
        lit += pixel.lit;
    }
    return {relative_variance(first, second, between), relative_variance(first, second, behind),
            rays / (2 * static_cast<double>(pixels.size())), ends > 0 ? lit / ends : 1};
}

PilotPaths trace_pilot(const RenderScene& scene, const RenderOptions& options,
                       const PilotTeam& team)
{
    const RenderOptions small = small_options(options);
    const auto width = static_cast<std::size_t>(small.width);
    const Part rows = team.part(static_cast<std::size_t>(small.height));
    std::vector<PilotPixel> own(rows.size() * width);
    tbb::parallel_for(rows.begin * width, rows.end * width, [&](std::size_t pixel) {
        own[pixel - rows.begin * width] = pilot_pixel(scene, small, pixel);
    });
    return describe(joined(team, std::move(own)), small.width, small.height);
}

/// docs/light_transport.md (50).  caustics: there may be photons of them.
bool paths_pay(const PilotPaths& found, bool caustics)
{
    const double gathered = std::max(0.0, found.variance - found.behind);
    const double cost = found.rays * (caustics ? kCausticCost : 1);
    return found.lit >= kLeastLit && found.variance * cost < kMostForPaths * gathered;
}

} // namespace

IndirectLight choose_indirect(const RenderScene& scene, const RenderOptions& options,
                              const PilotControl& pilots, RenderStatistics& statistics)
{
    IndirectLight out = options.indirect;
    if (!options.light.indirect || scene.has_media() || uses_methods(options.dissertation))
        out = IndirectLight::photons;
    if (out == IndirectLight::automatic)
        out = paths_pay(trace_pilot(scene, options, pilots.team),
                        options.light.caustic && !scene.specular_targets.empty())
                  ? IndirectLight::paths
                  : IndirectLight::photons;
    statistics.indirect_by = out;
    return out;
}

} // namespace hipmap
