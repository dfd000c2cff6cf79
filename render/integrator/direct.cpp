#include "render/integrator/direct.h"

#include "render/integrator/light_sample_allocation.h"
#include "render/integrator/pass_photons.h"
#include "render/integrator/sampled_source.h"

#include <utility>

namespace hipmap {

namespace {

PassMapSet make_maps(const MappedScene& mapped, const RenderOptions& options, std::uint64_t pass,
                     RenderStatistics& statistics)
{
    const RenderScene& scene = mapped.scene;
    TracedPhotons traced = trace_pass(scene, photon_options(scene, options, pass), statistics);
    const Stopwatch watch;
    PassMapSet maps;
    maps.volume = build_volume(scene, traced, volume_radii(scene, traced, options), 1);
    const MapRequest request{options.maps, options.dissertation};
    maps.caustic = build_maps(mapped, std::exchange(traced.caustic, {}), request,
                              statistics.caustic); // which frees them
    maps.global = build_maps(mapped, traced.global, request, statistics.global);
    count_maps(maps.volume, watch, statistics);
    return maps;
}

struct DirectMethod {
    using Scratch = EyeScratch;
    static constexpr double kBegun = 0.2;
    static constexpr BiasKnowledge kBias = BiasKnowledge::unknown;

    const RenderScene& scene;
    MapSurfaces surfaces;

    explicit DirectMethod(const RenderScene& of) : scene(of), surfaces(of.mesh(), of.partition) {}

    class Pass {
      public:
        Pass(const DirectMethod& method, const PictureJob& job, RenderStatistics& statistics)
            : maps_(make_maps({method.scene, method.surfaces}, job.options, job.pass, statistics)),
              gathered_{method.scene, method.surfaces,    maps_.caustic,
                        maps_.global, job.options.direct, maps_.volume ? &*maps_.volume : nullptr}
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

} // namespace

PassSource make_direct_source(const RenderScene& scene, const RenderOptions& options,
                              RenderStatistics& statistics, const PilotControl& pilots)
{
    SampleAllocation allocation;
    allocation.lights =
        allocate_light_samples(measure_light_noise(scene, options), options.samples);
    return make_sampled_source<DirectMethod>(scene, options, statistics, pilots, allocation);
}

} // namespace hipmap
