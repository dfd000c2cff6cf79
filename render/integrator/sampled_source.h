#pragma once

#include "render/integrator/pass_source.h"
#include "render/integrator/picture_tiles.h"

#include <memory>

namespace hipmap {

/// What a Method inherits whose threads need no memory of their own (make_sampled_source).
struct WithoutScratch {
    struct Scratch {};
    static constexpr double kBegun = 0;
    static void count(const Scratch& /*scratch*/, RenderStatistics& /*statistics*/) {}
};

/// Renders one pass by a method (make_sampled_source).
template <typename Method>
RenderedPass render_sampled(const Method& method, const PictureJob& job, const PassControl& control,
                            RenderStatistics& statistics)
{
    using Scratch = typename Method::Scratch;
    const typename Method::Pass pass(method, job, statistics);
    return render_clamped_tiles<1, Scratch>(
        job, after(control, Method::kBegun), statistics,
        TileTracer{[&](const Ray& ray, SeenLights seen, RandomSequence& random, Scratch& scratch)
                       -> Samples<1> { return {pass.trace(ray, seen, random, scratch)}; },
                   [](const auto& /*rows*/, const Scratch& /*scratch*/) {},
                   [&](const Scratch& scratch) { Method::count(scratch, statistics); }});
}

/// Renders a coarse image by a method.
template <typename Method>
CoarseImage render_coarse_sampled(const Method& method, const RenderOptions& options,
                                  const PilotControl& pilots)
{
    using Scratch = typename Method::Scratch;
    RenderStatistics ignored;
    const RenderOptions few = pilot_options(options);
    const SampleAllocation evenly;
    const typename Method::Pass pass(method, {method.scene, few, kPilotPass, evenly}, ignored);
    return render_coarse<1, Scratch>(
        {method.scene, options, kPilotPass, evenly}, pilots,
        [&](const Ray& ray, SeenLights seen, RandomSequence& random,
            Scratch& scratch) -> Samples<1> { return {pass.trace(ray, seen, random, scratch)}; });
}

/// Makes an integrator whose image is the mean of samples that know nothing of each other.  Borrows
/// and counts as make_pass_source does; renders the pilot.  A Method is
///     what serves all passes of a scene, which it borrows, with at(scene), the same for another
///         moment of it;
///     Method::Pass(method, job, statistics): what serves one pass, such as photon maps, with
///         trace(ray, seen, random, scratch), the radiance along an eye ray, thread-safe;
///     Method::Scratch: memory of one thread, and Method::count(scratch, statistics);
///     Method::kBegun: the share of a pass that is done when its Pass is there, for the progress;
///     Method::kBias: what is known of the bias of its images.
template <typename Method>
PassSource make_sampled_source(Method made, const RenderOptions& options,
                               RenderStatistics& statistics, const PilotControl& pilots,
                               SampleAllocation allocated = {})
{
    const RenderScene& scene = made.scene;
    const auto method = std::make_shared<const Method>(std::move(made));
    const auto allocation = std::make_shared<const SampleAllocation>(std::move(allocated));
    PassSource source;
    set_window(source, options);
    source.photons = options.photons;
    source.bias = Method::kBias;
    source.clamped = options.clamp > 0;
    source.allocation = checksum(*allocation);
    RenderStatistics ignored;
    const RenderOptions small = pilot_options(options);
    if (pilots.coarse)
        pilots.coarse(render_coarse_sampled(*method, options, pilots));
    source.pilot_mean = mean_of(
        render_sampled(*method, {scene, small, kPilotPass, {}}, {}, ignored).images.radiance);
    source.render = [&scene, &options, &statistics, method,
                     allocation](std::uint64_t pass, const PassControl& control) {
        return render_sampled(*method, {scene, options, pass, *allocation}, control, statistics);
    };
    source.render_in = [&options, &statistics, method, allocation](
                           const RenderScene& now, std::uint64_t pass, const PassControl& control) {
        return render_sampled(method->at(now), {now, options, pass, *allocation}, control,
                              statistics);
    };
    return source;
}

} // namespace hipmap
