#include "render/integrator/integrators.h"

#include "render/integrator/direct.h"
#include "render/integrator/occlusion.h"
#include "render/integrator/path_tracer.h"
#include "render/integrator/progressive.h"

#include <algorithm>
#include <cassert>

namespace hipmap {

namespace {

template <auto make>
PassSource without_cache(const RenderScene& scene, const RenderOptions& options,
                         RenderStatistics& statistics, PhotonCache* /*cache*/,
                         const PilotControl& pilots)
{
    return make(scene, options, statistics, pilots);
}

constexpr IntegratorKind kKinds[] = {
    {.id = Integrator::progressive,
     .name = "progressive",
     .help = "photon maps and a final-gather ray, with radii that shrink from pass to pass",
     .photons = true,
     .bounces = false,
     .make = make_progressive_source},
    {.id = Integrator::direct,
     .name = "direct",
     .help = "estimates at the first diffuse surface, fast and blurred",
     .photons = true,
     .bounces = false,
     .make = without_cache<make_direct_source>},
    {.id = Integrator::path,
     .name = "path",
     .help = "path tracing without photons, for comparison",
     .photons = false,
     .bounces = true,
     .make = without_cache<make_path_source>},
    {.id = Integrator::occlusion,
     .name = "occlusion",
     .help = "ambient occlusion without light, to look at the geometry",
     .photons = false,
     .bounces = false,
     .make = without_cache<make_occlusion_source>},
};

} // namespace

std::span<const IntegratorKind> integrator_kinds()
{
    return kKinds;
}

const IntegratorKind& kind_of(Integrator id)
{
    const auto found = std::ranges::find(kKinds, id, &IntegratorKind::id);
    assert(found != std::end(kKinds));
    return *found;
}

PassSource make_pass_source(const RenderScene& scene, const RenderOptions& options,
                            RenderStatistics& statistics, PhotonCache* cache,
                            const PilotControl& pilots)
{
    return kind_of(options.integrator).make(scene, options, statistics, cache, pilots);
}

} // namespace hipmap
