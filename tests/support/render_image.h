#pragma once

#include "render/integrator/integrators.h"
#include "render/integrator/run_passes.h"

namespace hipmap {

/// Integrator direct unless a test says otherwise.
struct ImageOptions : RenderOptions {
    ImageOptions() { integrator = Integrator::direct; }
    std::uint64_t passes = 1;
};

struct RenderedImage {
    Image image;
    RenderStatistics statistics;
    bool stopped = false;
};

struct RenderControl {
    std::function<void(double)> progress; ///< 0 to 1
    const std::atomic<bool>* stop = nullptr;
};

/// The mean of options.passes passes from the scene's camera.
inline RenderedImage render_image(const RenderScene& scene, const ImageOptions& options,
                                  const RenderControl& control)
{
    RenderedImage out;
    const PassSource source = make_pass_source(scene, options, out.statistics);
    RenderState state = begin_state(source, {});
    StopRules rules;
    rules.passes = options.passes;
    RunControl run;
    run.stop = control.stop;
    run.progress = [&control](const RunProgress& progress) {
        if (control.progress)
            control.progress(progress.done.value_or(0));
    };
    RunResult result = run_passes(source, rules, run, state);
    out.image = std::move(result.image);
    out.stopped = result.reason == StopReason::caller;
    return out;
}

} // namespace hipmap
