#include "render/run_plan.h"

#include "render/effects/drop_effects.h"
#include "render/integrator/integrators.h"

namespace hipmap {

EffectPlan plan_run(RenderArguments& arguments, Scene& scene, const Partition& partition,
                    std::vector<std::string> moving)
{
    EffectOptions options;
    options.switches = arguments.effects;
    options.shutter = arguments.shutter > 0;
    options.moving = std::move(moving);
    const IntegratorKind& integrator = kind_of(arguments.render.integrator);
    options.bounces = integrator.photons ? arguments.render.dissertation.mode != MapMode::none
                                         : integrator.bounces;
    const EffectPlan out = plan_effects(scene, partition, options);
    arguments.render.light = light_classes(out);
    drop_effects(scene, out);
    return out;
}

void explain(const EffectPlan& plan, Report& report)
{
    for (const PlannedEffect& effect : plan.effects)
        report.line(describe(effect));
}

} // namespace hipmap
