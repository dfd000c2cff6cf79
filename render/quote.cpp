#include "render/quote.h"

#include "render/effects/drop_effects.h"

#include <algorithm>
#include <cmath>

namespace hipmap {

namespace {

/// Sketches have this part of the sides of the image, but not fewer pixels a side than these.
constexpr int kSketchPart = 4;
constexpr int kLeastSketchSide = 48;
/// Fewer light paths would make the noise hide what effects add.
constexpr std::uint64_t kLeastSketchPhotons = 50'000;
/// Passes of a sketch: the fewest whose differences have a known spread and a bias by radii.
constexpr std::uint64_t kSketchPasses = kFewestBatches;

/// A small image of the frame with other settings.
struct Sketch {
    RenderState state;
    BiasKnowledge bias = BiasKnowledge::unknown;
    double seconds = 0; ///< with pilots and all that the scene needs
    double before = 0;  ///< seconds before the first pass
    bool whole = false; ///< not stopped
};

/// Settings that differ from those of the frame.
struct Change {
    std::string option;
    RenderOptions options;
    EffectPlan effects;
    bool of_scene = false; ///< the scene changes with the effects
};

/// The divisor of both sides.
double sketch_part(const RenderOptions& options)
{
    const int shorter = std::min(options.width, options.height);
    return std::clamp(shorter / static_cast<double>(kLeastSketchSide), 1.0, double{kSketchPart});
}

RenderOptions sketch_options(RenderOptions options)
{
    const double part = sketch_part(options);
    const auto less = [part](int pixels) { return static_cast<int>(pixels / part); };
    const PixelRect crop = options.crop;
    options.width = std::max(less(options.width), 1);
    options.height = std::max(less(options.height), 1);
    const double photons = static_cast<double>(options.photons) / (part * part);
    options.photons = std::max(static_cast<std::uint64_t>(photons),
                               std::min(options.photons, kLeastSketchPhotons));
    if (!crop.empty()) {
        const int x = std::min(less(crop.x0), options.width - 1);
        const int y = std::min(less(crop.y0), options.height - 1);
        options.crop = {x, y, std::clamp(less(crop.x1), x + 1, options.width),
                        std::clamp(less(crop.y1), y + 1, options.height)};
    }
    return options;
}

double pixels_of_pass(const RenderOptions& options)
{
    const PixelRect pixels = rendered_pixels(options);
    return pixels.width() * static_cast<double>(pixels.height());
}

double seconds_of_pass(const RenderState& state)
{
    return state.seconds /
           static_cast<double>(std::max<std::uint64_t>(count(state.film.passes), 1));
}

Sketch render_sketch(const QuotedFrame& frame, const Change& change, const RenderScene& scene,
                     const std::atomic<bool>& stop)
{
    const Stopwatch watch;
    const FramePasses passes = {frame.passes.frame, frame.passes.source, change.effects,
                                change.options};
    RenderStatistics statistics;
    const PassSource source = make_frame_source(passes, scene, statistics, nullptr);
    Sketch out;
    out.bias = source.bias;
    out.state = begin_state(source, {});
    RunControl control;
    control.stop = &stop;
    StopRules rules;
    rules.passes = kSketchPasses;
    rules.fireflies = frame.passes.frame.arguments.files.fireflies;
    run_passes(source, rules, control, out.state);
    out.whole = count(out.state.film.passes) == kSketchPasses;
    out.seconds = watch.seconds();
    out.before = out.seconds - out.state.seconds;
    return out;
}

/// The same with the scene that the changed effects leave.
Sketch render_changed(const QuotedFrame& frame, const Change& change, const std::atomic<bool>& stop)
{
    if (!change.of_scene)
        return render_sketch(frame, change, frame.scene, stop);
    const Stopwatch watch;
    Scene scene = frame.scene.scene;
    drop_effects(scene, change.effects);
    EnvironmentMap sky;
    if (change.effects.has(Effect::environment))
        sky = frame.scene.environment_map;
    const RenderScene changed(scene, frame.scene.partition, std::move(sky));
    Sketch out = render_sketch(frame, change, changed, stop);
    out.seconds = watch.seconds();
    return out;
}

Change leave_out(const FramePasses& passes, const RenderOptions& options, Effect effect)
{
    Change out{"--effects=-" + std::string(name_of(effect)), options, passes.effects, true};
    out.effects.effects[static_cast<std::size_t>(effect)].on = false;
    out.options.light = light_classes(out.effects);
    out.of_scene = out.options.light == passes.options.light;
    return out;
}

/// Returns the other integrators; path is left out where it cannot find some light.
std::vector<Change> other_integrators(const QuotedFrame& frame, const RenderOptions& options)
{
    std::vector<Change> out;
    for (const IntegratorKind& kind : integrator_kinds()) {
        if (kind.id == options.integrator || kind.id == Integrator::occlusion ||
            (kind.bounces && !frame.rendered.unreachable.empty()))
            continue;
        out.push_back({std::string("--integrator ") + kind.name, options, frame.passes.effects});
        out.back().options.integrator = kind.id;
    }
    return out;
}

/// Compares changes with the frame as it is.
class Comparison {
  public:
    Comparison(const QuotedFrame& frame, const std::atomic<bool>& stop)
        : frame_(frame), stop_(stop), options_(sketch_options(frame.passes.options)),
          pixels_(pixels_of_pass(frame.passes.options) / pixels_of_pass(options_))
    {
        const RenderState& state = frame.rendered.state;
        quote_.error = frame.passes.frame.arguments.stops.quoted_error;
        if (state.checks.empty() || !(state.checks.back().error.error > 0))
            return;
        const double before = seconds_before_passes(frame.rendered);
        whole_ = error_cost(state.checks, error_law(state.checks, state.radius_decay), quote_.error,
                            {state.photons_per_pass, before});
        room_ = kQuoteShare * whole_.seconds - state.seconds - before;
    }

    Quote compare()
    {
        const FramePasses& passes = frame_.passes;
        sketch_as_is();
        if (passes.options.integrator != Integrator::occlusion)
            for (const Change& change : other_integrators(frame_, options_))
                if (const std::optional<Sketch> other = sketch(change))
                    quote_.integrators.push_back({change.option, cost_of(*other), other->bias});
        for (const PlannedEffect& planned : passes.effects.effects)
            if (planned.on && can_be_left_out(planned.effect))
                compare(leave_out(passes, options_, planned.effect));
        return std::move(quote_);
    }

  private:
    /// What sketching the frame as it is will take, about.
    double expected() const
    {
        const RenderState& state = frame_.rendered.state;
        const double seconds =
            frame_.rendered.pilots.seconds + kSketchPasses * seconds_of_pass(state);
        const double photons = static_cast<double>(frame_.passes.options.photons) /
                               static_cast<double>(std::max<std::uint64_t>(options_.photons, 1));
        return seconds / std::min(pixels_, std::max(photons, 1.0));
    }

    void sketch_as_is()
    {
        if (expected() > room_ || stop_)
            return;
        as_is_ = render_sketch(frame_, {{}, options_, frame_.passes.effects}, frame_.scene, stop_);
        spend(as_is_);
        const double sketched = seconds_of_pass(as_is_.state);
        scale_ = sketched > 0 ? seconds_of_pass(frame_.rendered.state) / sketched : 1;
        scale_before_ =
            as_is_.before > 0 ? seconds_before_passes(frame_.rendered) / as_is_.before : 1;
    }

    void compare(const Change& without)
    {
        if (const std::optional<Sketch> other = sketch(without))
            quote_.effects.push_back(
                {without.option, saved_by(*other),
                 whole_.passes * seconds_of_pass(frame_.rendered.state) * saved_by(*other),
                 difference_of(as_is_.state.film, other->state.film)});
    }

    /// The share of the time of a pass.
    double saved_by(const Sketch& other) const
    {
        const double own = seconds_of_pass(as_is_.state);
        return own > 0 ? 1 - seconds_of_pass(other.state) / own : 0;
    }

    /// None: there is no time for it, or nothing to compare with.
    std::optional<Sketch> sketch(const Change& change)
    {
        const double expected =
            as_is_.seconds + (change.of_scene ? frame_.rendered.rays.seconds : 0.0);
        const bool room = frame_.passes.frame.arguments.memory_gib == 0 || !change.of_scene;
        if (stop_)
            return std::nullopt;
        if (!as_is_.whole || expected > room_ || !room) {
            quote_.not_compared.push_back(change.option);
            return std::nullopt;
        }
        std::optional<Sketch> out = render_changed(frame_, change, stop_);
        spend(*out);
        if (!out->whole)
            out.reset();
        return out;
    }

    void spend(const Sketch& sketch)
    {
        room_ -= sketch.seconds;
        quote_.seconds += sketch.seconds;
    }

    /// What the error costs with the settings of a sketch, for an image of the frame's size.
    ErrorCost cost_of(const Sketch& sketch) const
    {
        const RenderState& state = sketch.state;
        ErrorCost out;
        out.error = quote_.error;
        if (state.checks.empty())
            return out;
        out.passes = passes_for(error_law(state.checks, state.radius_decay), out.error);
        out.seconds = scale_before_ * sketch.before + scale_ * out.passes * seconds_of_pass(state);
        out.photons = out.passes * static_cast<double>(frame_.rendered.state.photons_per_pass);
        return out;
    }

    const QuotedFrame& frame_;
    const std::atomic<bool>& stop_;
    const RenderOptions options_; ///< of sketches
    const double pixels_;         ///< of the frame for each of a sketch
    ErrorCost whole_;             ///< of the frame as it is
    Sketch as_is_;
    double scale_ = 1;        ///< time of a pass of the frame over that of its own sketch
    double scale_before_ = 1; ///< time before the frame's first pass over that of its own sketch
    double room_ = 0;         ///< s
    Quote quote_;
};

} // namespace

Quote make_quote(const QuotedFrame& frame, const std::atomic<bool>& stop)
{
    return Comparison(frame, stop).compare();
}

} // namespace hipmap
