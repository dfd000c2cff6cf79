#include "render/integrator/pass_photons.h"

#include "common/stopwatch.h"

namespace hipmap {

namespace {

/// Light paths for each one that is aimed at specular surfaces besides: nearly all of those leave a
/// caustic photon, where few of the others would.
constexpr std::uint64_t kPathsPerCausticPath = 4;

} // namespace

PhotonOptions photon_options(const RenderOptions& options, std::uint64_t pass)
{
    PhotonOptions out{options.photons, options.seed, pass, options.direct == DirectLight::photons,
                      options.photons / kPathsPerCausticPath};
    out.light = options.light;
    if (options.maps.mode == MapMode::none || options.integrator == Integrator::path) {
        out.light = {false, false};
        out.store_direct = false;
    }
    return out;
}

TracedPhotons trace_pass(const RenderScene& scene, const PhotonOptions& options,
                         RenderStatistics& statistics)
{
    const Stopwatch watch;
    TracedPhotons traced = trace_photons(scene, options);
    statistics.emitted += traced.emitted;
    statistics.aimed += traced.aimed;
    statistics.dropped_photons += traced.dropped;
    statistics.cut_paths += traced.cut;
    statistics.power = traced.power;
    statistics.seconds_photons += watch.seconds();
    return traced;
}

PhotonMaps build_maps(const RenderScene& scene, const std::vector<Photon>& photons,
                      const MapOptions& options, KindStatistics& kind, RenderStatistics& statistics)
{
    const Stopwatch watch;
    MapOptions of_maps = options;
    of_maps.directions = scene.directional;
    PhotonMaps maps = build_photon_maps(photons, scene.mesh(), scene.partition, of_maps);
    kind.stored += maps.size;
    kind.shared_maps = maps.maps.size();
    kind.largest_map = maps.largest_map();
    kind.local_maps = maps.locals.maps.size() + maps.local_tier.maps.size();
    kind.group_maps = maps.groups.maps.size() + maps.group_tier.maps.size();
    kind.local_plan = maps.local_tier.plan;
    kind.group_plan = maps.group_tier.plan;
    statistics.seconds_maps += watch.seconds();
    statistics.processor_maps += watch.processor_seconds();
    return maps;
}

} // namespace hipmap
