#include "render/integrator/pass_source.h"

#include "render/integrator/light_sample_allocation.h"
#include "render/integrator/pass_photons.h"
#include "render/integrator/path_tracer.h"
#include "render/integrator/picture_tiles.h"
#include "render/integrator/progressive.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace hipmap {

namespace {

/// The share of its photons in the work of a pass, for the progress shown.
constexpr double kPhotonShare = 0.2;

PassMapSet make_maps(const MappedScene& mapped, const RenderOptions& options, std::uint64_t pass,
                     RenderStatistics& statistics)
{
    const RenderScene& scene = mapped.scene;
    TracedPhotons traced = trace_pass(scene, photon_options(scene, options, pass), statistics);
    const Stopwatch watch;
    PassMapSet maps;
    maps.volume = build_volume(scene, traced, volume_radii(scene, traced, options), 1);
    maps.caustic = build_maps(mapped, std::exchange(traced.caustic, {}), options.maps,
                              options.dissertation, statistics.caustic); // which frees them
    maps.global =
        build_maps(mapped, traced.global, options.maps, options.dissertation, statistics.global);
    count_maps(maps.volume, watch, statistics);
    return maps;
}

RenderedPass render_pass(const RenderScene& scene, const MapSurfaces& surfaces,
                         const PictureJob& job, const PassControl& control,
                         RenderStatistics& statistics)
{
    const RenderOptions& options = job.options;
    const PassMapSet maps = make_maps({scene, surfaces}, options, job.pass, statistics);
    const PassMaps pass_maps{scene,       surfaces,       maps.caustic,
                             maps.global, options.direct, maps.volume ? &*maps.volume : nullptr};
    return render_clamped_tiles<1, EyeScratch>(
        job, after(control, kPhotonShare), statistics,
        [&](const Ray& ray, SeenLights seen, RandomSequence& random,
            EyeScratch& scratch) -> Samples<1> {
            if (options.integrator == Integrator::path)
                return {trace_path(scene, ray, random, options.light)};
            return {trace_eye_path(pass_maps, ray, seen, random, scratch)};
        },
        [&](const EyeScratch& scratch) {
            statistics.caustic.add_searches(scratch.caustic);
            statistics.global.add_searches(scratch.global);
        });
}

double pilot_mean(const RenderScene& scene, const MapSurfaces& surfaces,
                  const RenderOptions& options)
{
    RenderStatistics ignored;
    const RenderOptions small = pilot_options(options);
    const RenderedPass pilot =
        render_pass(scene, surfaces, {scene, small, kPilotPass, {}}, {}, ignored);
    return mean_of(pilot.images.radiance);
}

} // namespace

RenderOptions pilot_options(RenderOptions options)
{
    constexpr int kPilotSide = 32;
    constexpr std::uint64_t kPilotShare = 16;
    options.width = std::min(options.width, kPilotSide);
    options.height = std::min(options.height, kPilotSide);
    options.samples = 1;
    options.photons /= kPilotShare;
    options.filter = PixelFilter::box;
    return options;
}

double mean_of(const Image& image)
{
    double sum = 0;
    for (const Rgb& pixel : image.pixels)
        sum += double{pixel.x} + double{pixel.y} + double{pixel.z};
    return sum / (3 * static_cast<double>(std::max<std::size_t>(1, image.pixels.size())));
}

PassControl after(const PassControl& control, double begun)
{
    PassControl rest = control;
    if (control.progress)
        rest.progress = [&control, begun](double part) {
            control.progress(begun + (1 - begun) * part);
        };
    return rest;
}

PassSource make_pass_source(const RenderScene& scene, const RenderOptions& options,
                            RenderStatistics& statistics, PhotonCache* cache)
{
    if (options.integrator == Integrator::progressive)
        return make_progressive_source(scene, options, statistics, cache);
    const auto surfaces = std::make_shared<MapSurfaces>(scene.mesh(), scene.partition);
    PassSource source;
    source.width = options.width;
    source.height = options.height;
    source.photons = options.photons;
    source.pilot_mean = pilot_mean(scene, *surfaces, options);
    source.bias =
        options.integrator == Integrator::path ? BiasKnowledge::unbiased : BiasKnowledge::unknown;
    source.clamped = options.clamp > 0;
    auto allocation = std::make_shared<SampleAllocation>();
    if (options.integrator == Integrator::direct)
        allocation->lights = allocate_light_samples(scene, options);
    source.allocation = checksum(*allocation);
    source.render = [&scene, &options, &statistics, surfaces,
                     allocation](std::uint64_t pass, const PassControl& control) {
        return render_pass(scene, *surfaces, {scene, options, pass, *allocation}, control,
                           statistics);
    };
    source.render_in = [&options, &statistics, allocation](
                           const RenderScene& now, std::uint64_t pass, const PassControl& control) {
        return render_pass(now, MapSurfaces(now.mesh(), now.partition),
                           {now, options, pass, *allocation}, control, statistics);
    };
    return source;
}

} // namespace hipmap
