#include "render/integrator/progressive.h"

#include "common/stopwatch.h"
#include "render/integrator/gather_path.h"
#include "render/integrator/pass_photons.h"
#include "render/integrator/picture_tiles.h"

#include <memory>

namespace hipmap {

namespace {

/// Of the work of a pass, what its photons are taken for in the progress shown.
constexpr double kPhotonShare = 0.3;

/// What all passes share.
struct Progressive {
    MapSurfaces surfaces;
    PilotMaps pilot;
};

TracedPhotons trace_linked(const RenderScene& scene, const RenderOptions& options,
                           std::uint64_t pass, RenderStatistics& statistics)
{
    PhotonOptions photons = photon_options(options, pass);
    photons.store_direct = true; // for gather rays
    photons.link_bounces = true;
    if (options.maps.mode == MapMode::none)
        photons.paths = photons.caustic_paths = 0;
    return trace_pass(scene, photons, statistics);
}

/// Photons of their own, as many as a pass has.
PilotMaps make_pilot(const RenderScene& scene, const RenderOptions& options)
{
    RenderStatistics ignored;
    const TracedPhotons traced = trace_linked(scene, options, kPilotPass, ignored);
    std::vector<Photon> indirect;
    indirect.reserve(traced.bounces.size());
    for (const BouncedPhoton& bounced : traced.bounces)
        indirect.push_back(bounced.photon);
    return {build_maps(scene, traced.caustic, options.maps, ignored.caustic, ignored),
            build_maps(scene, traced.global, options.maps, ignored.global, ignored),
            build_maps(scene, indirect, options.maps, ignored.indirect, ignored)};
}

/// Of the pilot's maps and of the pass'.
void count_searches(const GatherScratch& scratch, RenderStatistics& statistics)
{
    statistics.caustic.searches += scratch.caustic.search.statistics;
    statistics.caustic.searches += scratch.pilot_caustic.statistics;
    statistics.global.searches += scratch.global.search.statistics;
    statistics.global.searches += scratch.pilot_global.statistics;
    statistics.indirect.searches += scratch.indirect.search.statistics;
    statistics.indirect.searches += scratch.pilot_indirect.statistics;
}

RenderedPass render_pass(const RenderScene& scene, const Progressive& shared,
                         const RenderOptions& options, std::uint64_t pass,
                         const PassControl& control, RenderStatistics& statistics)
{
    TracedPhotons traced = trace_linked(scene, options, pass, statistics);
    const Stopwatch weighing;
    const std::vector<Photon> weighed = weigh_bounces(traced, shared.pilot, shared.surfaces);
    statistics.seconds_maps += weighing.seconds();
    const PhotonMaps caustic =
        build_maps(scene, traced.caustic, options.maps, statistics.caustic, statistics);
    const PhotonMaps global =
        build_maps(scene, traced.global, options.maps, statistics.global, statistics);
    const PhotonMaps indirect =
        build_maps(scene, weighed, options.maps, statistics.indirect, statistics);
    traced = {};

    const double shrink = pass == kPilotPass ? 1.0 : radius_of_pass(pass);
    const GatherMaps maps{scene,        shared.surfaces,           caustic, global, indirect,
                          shared.pilot, static_cast<float>(shrink)};
    return render_tiles<3, GatherScratch>(
        {scene.scene.cameras[scene.scene.camera], options, pass}, after(control, kPhotonShare),
        statistics,
        [&](const Ray& ray, RandomSequence& random, GatherScratch& scratch) {
            return trace_gather_path(maps, ray, random, scratch);
        },
        [&](const GatherScratch& scratch) { count_searches(scratch, statistics); });
}

double pilot_mean(const RenderScene& scene, const Progressive& shared, const RenderOptions& options)
{
    RenderStatistics ignored;
    const RenderOptions small = pilot_options(options);
    return mean_of(render_pass(scene, shared, small, kPilotPass, {}, ignored).images.radiance);
}

} // namespace

PassSource make_progressive_source(const RenderScene& scene, const RenderOptions& options,
                                   RenderStatistics& statistics)
{
    const std::shared_ptr<const Progressive> shared(
        new Progressive{MapSurfaces(scene.mesh(), scene.partition), make_pilot(scene, options)});
    PassSource source;
    source.width = options.width;
    source.height = options.height;
    source.pilot_mean = pilot_mean(scene, *shared, options);
    source.bias = BiasKnowledge::from_radii;
    source.render = [&scene, &options, &statistics, shared](std::uint64_t pass,
                                                            const PassControl& control) {
        return render_pass(scene, *shared, options, pass, control, statistics);
    };
    return source;
}

} // namespace hipmap
