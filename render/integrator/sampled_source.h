#pragma once

#include "render/integrator/expect_light.h"
#include "render/integrator/pass_source.h"
#include "render/integrator/picture_tiles.h"
#include "render/integrator/pilot_images.h"

#include <memory>
#include <optional>

namespace hipmap {

/// What a Method inherits whose threads need no memory of their own and whose pixels all have as
/// many samples (make_sampled_source).
struct SampledEvenly {
    struct Scratch {};
    static constexpr bool kShowsLights = true;
    static constexpr double kBegun = 0;
    static SampleAllocation allocate(const LightNoise& /*lights*/, const RenderOptions& /*options*/)
    {
        return {};
    }
    static void count(const Scratch& /*scratch*/, RenderStatistics& /*statistics*/) {}
};

/// Renders the image of a job from what serves its pass.  of_all: what its samples do with the seen
/// lights, if not as each pixel has it.
template <typename Method>
RenderedPass render_by(const typename Method::Pass& pass, const PictureJob& job,
                       const PassControl& control, RenderStatistics& statistics,
                       std::optional<SeenLights> of_all = {})
{
    using Scratch = typename Method::Scratch;
    return render_clamped_tiles<1, Scratch>(
        job, control, statistics,
        TileTracer{[&](const Ray& ray, SeenLights seen, RandomSequence& random,
                       Scratch& scratch) -> Samples<1> {
                       return {pass.trace(ray, of_all.value_or(seen), random, scratch)};
                   },
                   [](const auto& /*rows*/, const Scratch& /*scratch*/) {},
                   [&](const Scratch& scratch) { Method::count(scratch, statistics); }});
}

/// Renders one pass by a method (make_sampled_source).
template <typename Method>
RenderedPass render_sampled(const Method& method, const PictureJob& job, const PassControl& control,
                            RenderStatistics& statistics)
{
    const typename Method::Pass pass(method, job, statistics);
    return render_by<Method>(pass, job, after(control, Method::kBegun), statistics);
}

/// What pilots find out about an image.
struct Foreseen {
    double mean = 0; ///< of its channels
    SampleAllocation allocation = {};
    ExpectedLight expected = {};
};

/// Renders the pilots of a method's passes: two images from the same photons, if it has some; a
/// small one where the image shows no lights.
template <typename Method>
Foreseen foresee(const Method& method, const RenderOptions& options, const PilotControl& pilots)
{
    RenderStatistics ignored;
    const SampleAllocation evenly;
    if constexpr (!Method::kShowsLights) {
        const RenderOptions few = pilot_options(options);
        const PictureJob small{method.scene, few, kPilotPass, evenly};
        return {mean_of(render_sampled(method, small, {}, ignored).images.radiance)};
    } else {
        const RenderOptions whole = pilot_rows(options, {});
        const typename Method::Pass pass(method, {method.scene, whole, kPilotPass, evenly},
                                         ignored);
        const PilotImages found =
            render_pilots(method.scene, options, pilots.team, {},
                          [&](const RenderOptions& rows, std::uint64_t number) {
                              return render_by<Method>(pass, {method.scene, rows, number, evenly},
                                                       {.progress = {}, .stop = pilots.stop},
                                                       ignored, SeenLights::left_out)
                                  .images.radiance.pixels;
                          });
        Foreseen out{found.mean(), Method::allocate(found.lights, options)};
        out.expected = expect_light(found.noise(), options, out.allocation);
        return out;
    }
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
///     Method::kShowsLights: false if its images know of no light;
///     Method::allocate(lights, options): else the samples of each pixel in a pass;
///     Method::kBias: what is known of the bias of its images.
template <typename Method>
PassSource make_sampled_source(Method made, const RenderOptions& options,
                               RenderStatistics& statistics, const PilotControl& pilots)
{
    const RenderScene& scene = made.scene;
    const auto method = std::make_shared<const Method>(std::move(made));
    PassSource source;
    set_window(source, options);
    source.photons = options.photons;
    source.bias = Method::kBias;
    source.clamped = options.clamp > 0;
    if (pilots.coarse)
        pilots.coarse(render_coarse_sampled(*method, options, pilots));
    Foreseen found = foresee(*method, options, pilots);
    source.pilot_mean = found.mean;
    source.expected = found.expected;
    const auto allocation = std::make_shared<const SampleAllocation>(std::move(found.allocation));
    source.allocation = checksum(*allocation);
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
