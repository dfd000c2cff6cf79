#include "render/integrator/pass_photons.h"

#include "common/scene/light_path_rules.h"

#include <algorithm>
#include <cmath>

namespace hipmap {

namespace {

/// Joins what the paths without aim left, then what the aimed ones left.  without_aim: so many of
/// the first come before the others.
template <typename T>
void join_kinds(const PilotTeam& team, std::vector<T>& photons, std::uint64_t without_aim)
{
    const auto middle = photons.begin() + static_cast<std::ptrdiff_t>(without_aim);
    std::vector<T> out = joined(team, std::vector(photons.begin(), middle));
    const std::vector<T> aimed = joined(team, std::vector(middle, photons.end()));
    out.insert(out.end(), aimed.begin(), aimed.end());
    photons = std::move(out);
}

} // namespace

PhotonOptions photon_options(const RenderScene& scene, const RenderOptions& options,
                             std::uint64_t pass)
{
    PhotonOptions out{options.photons, options.seed, pass, options.direct == DirectLight::photons,
                      options.photons / kPathsPerCausticPath};
    out.light = options.light;
    out.media = scene.media.has_value();
    if (options.dissertation.mode == MapMode::none) {
        out.light = {false, false};
        out.store_direct = out.media = false;
    }
    return out;
}

void guide(const PhotonGuides* guides, PhotonOptions& photons)
{
    photons.guides = guides;
    if (guides != nullptr)
        photons.caustic_paths =
            static_cast<std::uint64_t>(guides->aimed_share * static_cast<double>(photons.paths));
}

double neighbours_by(const PhotonGuides* guides, EmissionGuide PhotonGuides::*kind)
{
    constexpr double kMostGain = 64; // estimates of more photons cost more
    return guides == nullptr ? 1 : std::cbrt(std::min(kMostGain, 1 / (guides->*kind).variance));
}

void count_guides(const PhotonGuides* guides, RenderStatistics& statistics)
{
    if (guides == nullptr)
        return;
    statistics.guided_variance = guides->without_aim.variance;
    statistics.guided_variance_aimed = guides->aimed.variance;
}

VolumeRadii volume_radii(const RenderScene& scene, const TracedPhotons& pilot,
                         const RenderOptions& options)
{
    // A ray passes many more discs than there are photons in a ball of the same radius.
    constexpr std::uint32_t kShare = 4;
    if (!scene.media)
        return {};
    return find_volume_radii(pilot.volume, std::max(2u, options.maps.neighbours / kShare),
                             scene.media->radius);
}

std::optional<VolumeMap> build_volume(const RenderScene& scene, const TracedPhotons& traced,
                                      const VolumeRadii& first, float shrink)
{
    if (!scene.media)
        return std::nullopt;
    return build_volume_map(traced.volume, first, shrink, scene.media->rays);
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
    traced.seen.passes = options.seen == nullptr ? 0 : 1;
    merge(statistics.seen, traced.seen);
    statistics.seconds_photons += watch.seconds();
    statistics.processor_photons += watch.processor_seconds();
    return traced;
}

TracedPhotons trace_together(const RenderScene& scene, const PhotonOptions& options,
                             const PilotTeam& team)
{
    if (!team.join || options.media)
        return trace_photons(scene, options);
    PhotonOptions part = options;
    part.part = team.rank;
    part.parts = team.count;
    part.count_paths = true;
    TracedPhotons out = trace_photons(scene, part);
    const PhotonCounts without_aim =
        out.emitted == 0 ? PhotonCounts{} : out.after_path[out.emitted - 1];
    out.after_path.clear();
    join_kinds(team, out.caustic, without_aim.caustic);
    join_kinds(team, out.global, without_aim.global);
    join_kinds(team, out.bounces, without_aim.bounces);
    out.glossy = joined(team, std::move(out.glossy));
    return out;
}

bool precomputes(const RenderScene& scene, const RenderOptions& options)
{
    return options.dissertation.irradiance == GatheredIrradiance::precomputed && !scene.directional;
}

DissertationOptions estimated(const RenderOptions& options)
{
    DissertationOptions out = without_levels(options.dissertation);
    out.irradiance = GatheredIrradiance::estimated;
    return out;
}

DissertationOptions gathered(const RenderScene& scene, const RenderOptions& options)
{
    return precomputes(scene, options) ? without_levels(options.dissertation) : estimated(options);
}

ChosenMaps build_maps(const MappedScene& mapped, const std::vector<Photon>& photons,
                      const MapRequest& request, KindStatistics& kind)
{
    MapOptions of_maps = request.options;
    of_maps.directions = of_maps.directions || mapped.scene.directional;
    ChosenMaps maps =
        build_chosen_maps(photons, mapped.surfaces, of_maps, request.asked, request.previous);
    const PhotonMaps& shared = shared_maps(maps);
    kind.stored += shared.size;
    kind.shared_maps = shared.maps.size();
    kind.largest_map = shared.largest_map();
    kind.levels = count_levels(maps);
    return maps;
}

void count_maps(const std::optional<VolumeMap>& volume, const Stopwatch& watch,
                RenderStatistics& statistics)
{
    statistics.volume_photons += volume ? volume->photons.size() : 0;
    statistics.seconds_maps += watch.seconds();
    statistics.processor_maps += watch.processor_seconds();
}

} // namespace hipmap
