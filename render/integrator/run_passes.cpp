#include "render/integrator/run_passes.h"

#include "common/stopwatch.h"
#include "render/integrator/time_left.h"

#include <algorithm>

namespace hipmap {

namespace {

/// The share of the time that saving may take.
constexpr double kSavingShare = 0.02;
constexpr double kSecondsBetweenSaves = 0.2;

/// Looks at the error before it is said how long it takes to meet one.
constexpr std::size_t kLooksToPredict = 2;

/// Share of the way from `begun` to `end` passes that `now` is.
double share_of(double begun, double now, double end)
{
    return end > begun ? (now - begun) / (end - begun) : 1;
}

class Run {
  public:
    Run(const StopRules& rules, double alpha, const RunControl& control, RenderState& state)
        : rules_(rules), alpha_(alpha), control_(control), state_(state), begun_(passes())
    {
    }

    std::optional<StopReason> reason_to_stop() const
    {
        if (control_.stop != nullptr && control_.stop->load())
            return StopReason::caller;
        if (passes() >= rules_.passes)
            return StopReason::passes;
        if (error_is_met(state_, rules_.error))
            return StopReason::error;
        if (rules_.quoted_error > 0 && predicts_enough(state_, rules_.quoted_error))
            return StopReason::passes;
        // No pass is begun that would not be over in time.
        if (!times_.whole.empty() && watch_.seconds() + times_.slowest() > rules_.seconds)
            return StopReason::time;
        return std::nullopt;
    }

    PassControl pass_control()
    {
        needed_ = passes_needed();
        times_.begun = watch_.seconds();
        PassControl pass;
        pass.stop = control_.stop;
        pass.progress = [this](double part) { tell(part); };
        return pass;
    }

    void add(std::uint64_t pass, const PassImages& images, double seconds)
    {
        const Stopwatch adding;
        add_pass(state_.film, pass, images);
        state_.seconds += seconds;
        times_.whole.push_back(seconds);
        if (passes() >= next_look_) {
            look_at_error(rules_.fireflies, state_);
            next_look_ = next_look(passes());
        }
        film_.add(adding);
    }

    void save_if_due()
    {
        const double since = watch_.seconds() - saved_;
        if (!control_.save || since < kSecondsBetweenSaves || since * kSavingShare < saving_)
            return;
        const Stopwatch saving;
        control_.save(state_);
        saving_ = saving.seconds();
        saved_ = watch_.seconds();
    }

    const Spent& film() const { return film_; }

  private:
    std::uint64_t passes() const { return count(state_.film.passes); }

    /// After which the error is met at a check; none: not known yet, docs/error.md (12).
    std::optional<double> passes_to_error() const
    {
        if (!(rules_.error > 0) || state_.checks.size() < kLooksToPredict)
            return std::nullopt;
        const double needed = std::min(passes_for(error_law(state_.checks, alpha_), rules_.error),
                                       static_cast<double>(kMostPasses));
        const auto before = static_cast<std::uint64_t>(needed) - 1;
        return static_cast<double>(next_check(std::max(before, passes())));
    }

    /// By the rules for passes and error; none: not known.
    std::optional<double> passes_needed() const
    {
        const std::optional<double> to_error = passes_to_error();
        if (rules_.passes == kMostPasses)
            return to_error;
        const auto asked = static_cast<double>(rules_.passes);
        return std::min(asked, to_error.value_or(asked));
    }

    /// By the rule that will end it first, of those whose end is known.
    std::optional<double> share_done(double part) const
    {
        std::optional<double> share;
        if (needed_)
            share = share_of(static_cast<double>(begun_), static_cast<double>(passes()) + part,
                             *needed_);
        if (std::isfinite(rules_.seconds))
            share = std::max(share.value_or(0), watch_.seconds() / rules_.seconds);
        if (share)
            share = std::min(*share, 1.0);
        return share;
    }

    /// Until the rule that will end it first does, of those whose end is known.
    std::optional<double> time_left(double part) const
    {
        const double now = watch_.seconds();
        std::optional<double> left;
        if (needed_)
            left = seconds_left(times_, now, part, *needed_ - static_cast<double>(passes()));
        if (!std::isfinite(rules_.seconds))
            return left;
        const double to_limit = seconds_to_limit(times_, now, rules_.seconds);
        return std::min(left.value_or(to_limit), to_limit);
    }

    void tell(double part) const
    {
        if (!control_.progress)
            return;
        RunProgress progress;
        progress.passes = passes();
        progress.done = share_done(part);
        progress.left = time_left(part);
        if (!state_.checks.empty())
            progress.error = state_.checks.back().error;
        control_.progress(progress);
    }

    const StopRules& rules_;
    const double alpha_;
    const RunControl& control_;
    RenderState& state_;
    const Stopwatch watch_;
    const std::uint64_t begun_;
    std::uint64_t next_look_ = next_look(begun_);
    PassTimes times_;
    Spent film_;
    std::optional<double> needed_;
    double saved_ = 0, saving_ = 0; ///< s
};

} // namespace

bool predicts_enough(const RenderState& state, double error)
{
    const std::uint64_t passes = count(state.film.passes);
    if (state.checks.empty() || state.checks.back().passes != passes)
        return false;
    const ErrorLaw law = error_law(state.checks, state.radius_decay);
    const double share = static_cast<double>(passes) / passes_for(law, error);
    return passes >= kBatches || share > kQuotePassShare;
}

RenderState begin_state(const PassSource& source, std::vector<Setting> settings)
{
    RenderState state;
    state.settings = std::move(settings);
    state.photons_per_pass = source.photons;
    state.radius_decay = source.alpha;
    state.film =
        make_film(source.width, source.height, source.pilot_mean, source.bias, source.clamped);
    state.film.place = source.place;
    state.film.allocation = source.allocation;
    state.film.expected = source.expected;
    return state;
}

RenderState resume_state(const PassSource& source, RenderState found,
                         const std::filesystem::path& path)
{
    const Film& film = found.film;
    if (film.width != source.width || film.height != source.height || film.place != source.place ||
        film.scale != film_scale(source.pilot_mean) || film.allocation != source.allocation ||
        film.bias != source.bias || film.cut.empty() == source.clamped)
        throw other_film(path);
    return found;
}

void set_image(const RenderState& state, PassImages unfinished, RunResult& result)
{
    const Film& film = state.film;
    if (!film.passes.ranges.empty()) {
        result.image = film_image(film);
        return;
    }
    result.image = std::move(unfinished.radiance);
    result.kept = std::move(unfinished.kept);
    if (result.image.pixels.empty())
        result.image = Image(film.width, film.height);
    result.kept.resize(film.pixel_count());
}

RunResult run_passes(const PassSource& source, const StopRules& rules, const RunControl& control,
                     RenderState& state)
{
    RunResult out;
    look_again(rules.fireflies, state);
    Run run(rules, source.alpha, control, state);
    PassImages unfinished;
    std::optional<StopReason> reason;
    while (!(reason = run.reason_to_stop())) {
        const std::uint64_t pass = next_missing(state.film.passes, rules.first_pass);
        const Stopwatch watch;
        const RenderedPass rendered = source.render(pass, run.pass_control());
        if (!rendered.whole) {
            unfinished = rendered.images;
            reason = StopReason::caller;
            break;
        }
        run.add(pass, rendered.images, watch.seconds());
        if (control.pass)
            control.pass(state);
        run.save_if_due();
    }
    out.reason = *reason;
    out.costs.film = run.film();
    const Stopwatch ending;
    look_at_error(rules.fireflies, state);
    set_image(state, std::move(unfinished), out);
    out.costs.film.add(ending);
    return out;
}

} // namespace hipmap
