#include "render/integrator/direct.h"

#include "render/integrator/emission_seeds.h"
#include "render/integrator/pass_photons.h"
#include "render/integrator/photon_guides.h"
#include "render/integrator/sampled_source.h"
#include "render/integrator/sky_guide.h"

#include <cmath>
#include <utility>

namespace hipmap {

namespace {

/// What pilots found for all passes.
struct DirectGuides {
    std::shared_ptr<const PhotonGuides> photons = {}; ///< null: paths start by power
    PlacedGuides sky = {};                            ///< of samples of the environments
};

PassMapSet make_maps(const MappedScene& mapped, const PhotonGuides* guides, const PictureJob& job,
                     RenderStatistics& statistics)
{
    const RenderScene& scene = mapped.scene;
    const RenderOptions& options = job.options;
    PhotonOptions photons = photon_options(scene, options, job.pass);
    guide(guides, photons);
    TracedPhotons traced = trace_pass(scene, photons, statistics);
    const Stopwatch watch;
    PassMapSet maps;
    maps.volume = build_volume(scene, traced, volume_radii(scene, traced, options), 1);
    maps.caustic =
        build_maps(mapped, std::exchange(traced.caustic, {}), {options.maps, options.dissertation},
                   statistics.caustic); // which frees them
    MapOptions of_global = options.maps;
    of_global.neighbours = static_cast<std::uint32_t>(
        std::lround(of_global.neighbours * neighbours_by(guides, &PhotonGuides::without_aim)));
    maps.global =
        build_maps(mapped, traced.global, {of_global, options.dissertation}, statistics.global);
    count_maps(maps.volume, watch, statistics);
    return maps;
}

struct DirectMethod {
    using Scratch = EyeScratch;
    static constexpr double kBegun = 0.2;
    static constexpr bool kShowsLights = true;
    static constexpr BiasKnowledge kBias = BiasKnowledge::unknown;

    const RenderScene& scene;
    MapSurfaces surfaces;
    std::shared_ptr<const DirectGuides> guides;

    DirectMethod(const RenderScene& of, std::shared_ptr<const DirectGuides> by)
        : scene(of), surfaces(of.mesh(), of.partition), guides(std::move(by))
    {
    }
    static SampleAllocation allocate(const LightNoise& lights, const RenderOptions& options)
    {
        SampleAllocation out;
        out.lights = allocate_light_samples(lights, options.samples);
        return out;
    }
    DirectMethod at(const RenderScene& now) const { return {now, guides}; }

    class Pass {
      public:
        Pass(const DirectMethod& method, const PictureJob& job, RenderStatistics& statistics)
            : maps_(make_maps({method.scene, method.surfaces}, method.guides->photons.get(), job,
                              statistics)),
              gathered_{method.scene,       method.surfaces,
                        maps_.caustic,      maps_.global,
                        job.options.direct, maps_.volume ? &*maps_.volume : nullptr,
                        &method.guides->sky}
        {
        }

        Rgb trace(const Ray& ray, SeenLights seen, RandomSequence& random, Scratch& scratch) const
        {
            return trace_eye_path(gathered_, ray, seen, random, scratch);
        }

      private:
        const PassMapSet maps_;
        const PassMaps gathered_;
    };

    static void count(const Scratch& scratch, RenderStatistics& statistics)
    {
        statistics.caustic.add_searches(scratch.caustic);
        statistics.global.add_searches(scratch.global);
    }
};

/// Finds where the image asks for photons, by few of them, whose paths start by power.
Importons find_importons(const DirectMethod& by_power, const RenderOptions& options,
                         const PilotTeam& team)
{
    RenderStatistics ignored;
    const RenderOptions few = pilot_options(options);
    const DirectMethod::Pass maps(by_power, {by_power.scene, few, kPilotPass, {}}, ignored);
    return trace_importons(
        by_power.scene, options,
        [&](const Ray& ray, RandomSequence& random, Importons& kept) {
            EyeScratch scratch;
            scratch.importons = &kept;
            return maps.trace(ray, SeenLights::left_out, random, scratch);
        },
        team);
}

/// Learns where light paths should start; a black image does not say it.
std::shared_ptr<const PhotonGuides> find_guides(const DirectMethod& by_power,
                                                const Importons& importons,
                                                const RenderOptions& options,
                                                const PilotControl& pilots)
{
    if (!(importons.light > 0))
        return nullptr;
    const MappedScene mapped{by_power.scene, by_power.surfaces};
    const auto no_bounces = [](const TracedPhotons&) { return std::vector<Photon>(); };
    return learn_guides(mapped, photon_options(mapped.scene, options, kPilotPass - 1),
                        make_worth(importons, mapped.surfaces, no_bounces),
                        emission_seeds(mapped.scene, importons, options.seed), pilots);
}

/// Finds what the passes share, from pilots, once the coarse image is there.
DirectGuides find_shared(const DirectMethod& by_power, const RenderOptions& options,
                         const PilotControl& pilots)
{
    const bool photons =
        options.emission == Emission::guided && !uses_methods(options.dissertation);
    const bool sky = options.gather == GatherDirections::guided &&
                     options.direct == DirectLight::shadow_rays &&
                     !by_power.scene.lights.environments.empty();
    DirectGuides out;
    if (!photons && !sky)
        return out;
    const Importons importons = find_importons(by_power, options, pilots.team);
    if (photons)
        out.photons = find_guides(by_power, importons, options, pilots);
    if (sky)
        out.sky = learn_sky(by_power.scene, importons.global, options.seed);
    return out;
}

} // namespace

PassSource make_direct_source(const RenderScene& scene, const RenderOptions& options,
                              RenderStatistics& statistics, const PilotControl& pilots)
{
    const DirectMethod by_power(scene, std::make_shared<const DirectGuides>());
    if (pilots.coarse)
        pilots.coarse(render_coarse_sampled(by_power, options, pilots));
    PilotControl rest = pilots;
    rest.coarse = {};
    const auto shared = std::make_shared<const DirectGuides>(find_shared(by_power, options, rest));
    count_guides(shared->photons.get(), statistics);
    PassSource source = make_sampled_source(DirectMethod(scene, shared), options, statistics, rest);
    source.allocation = mix_bits(source.allocation ^ checksum(shared->sky));
    if (shared->photons)
        source.allocation = mix_bits(source.allocation ^ checksum(*shared->photons));
    return source;
}

} // namespace hipmap
