#include "render/check_method.h"

#include "common/input_error.h"

namespace hipmap {

void check_method(const RenderOptions& render)
{
    const bool looks_at_maps = render.integrator == Integrator::direct;
    if (render.irradiance == GatheredIrradiance::precomputed &&
        render.integrator != Integrator::progressive)
        throw InputError("--irradiance precomputed is for --integrator progressive; choose that or "
                         "--irradiance estimated");
    if (render.direct == DirectLight::photons && !looks_at_maps)
        throw InputError("--direct photons is for --integrator direct; choose that or --direct "
                         "shadow-rays");
    if (render.maps.estimate == EstimateForm::thesis && !looks_at_maps)
        throw InputError("--estimate thesis is for --integrator direct; choose that or --estimate "
                         "clipped");
    if (render.direct == DirectLight::photons && render.maps.mode == MapMode::none)
        throw InputError("--direct photons needs photons, and --maps none has none; choose other "
                         "maps or --direct shadow-rays");
    if (render.alpha != RenderOptions().alpha && render.integrator != Integrator::progressive)
        throw InputError("--alpha is for --integrator progressive; choose that or leave it out");
}

} // namespace hipmap
