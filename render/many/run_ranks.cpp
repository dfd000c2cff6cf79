#include "render/many/run_ranks.h"

#include "render/many/pass_queue.h"

#include <cassert>
#include <thread>

namespace hipmap {

namespace {

/// The answer of the lead whether another round begins, as from_lead carries it.
constexpr std::uint64_t kAnotherRound = 100;

/// What a process renders between two sums, and what it took besides rendering.
struct Round {
    Film film;
    RunCosts costs; ///< of all rounds
};

/// All of a film but its sums, as words: saturated, number of ranges, ranges, lost.
std::vector<std::uint64_t> words_of(const Film& film)
{
    std::vector<std::uint64_t> out = {film.saturated, film.passes.ranges.size()};
    for (const PassRange& range : film.passes.ranges)
        out.insert(out.end(), {range.first, range.end});
    for (const auto& [key, passes] : film.lost)
        out.insert(out.end(), {key, passes});
    return out;
}

/// Adds the words of a film to those of another, whose ranges of passes may be in any order then:
/// many processes have many ranges, and to put each in its place at once takes time by their
/// square.
void add_words(const std::vector<std::uint64_t>& words, Film& film)
{
    film.saturated += words[0];
    const std::size_t lost = 2 + 2 * words[1];
    for (std::size_t i = 2; i < lost; i += 2)
        film.passes.ranges.push_back({words[i], words[i + 1]});
    for (std::size_t i = lost; i < words.size(); i += 2)
        film.lost[words[i]] += static_cast<std::uint32_t>(words[i + 1]);
}

/// Adds up what the ranks rendered in a round; leaves the film of the round of each rank empty.
void collect(Round& of, Film* into, Ranks& ranks)
{
    const Stopwatch waiting;
    ranks.wait();
    of.costs.wait.add(waiting);
    const Stopwatch adding;
    Film& round = of.film;
    const std::vector<std::vector<std::uint64_t>> words = ranks.gather(words_of(round));
    for (std::vector<std::int64_t> Film::*sums :
         {&Film::radiance, &Film::narrow, &Film::narrower, &Film::cut})
        ranks.add_up(round.*sums);
    if (into != nullptr) {
        round.saturated = 0;
        round.passes = {};
        round.lost = {};
        for (const std::vector<std::uint64_t>& of_rank : words)
            add_words(of_rank, round);
        round.passes = united({}, round.passes);
        merge_film(*into, round);
    }
    round = empty_like(round, round.width, round.height);
    of.costs.add.add(adding);
    ++of.costs.rounds;
}

/// Renders a pass into the film of a round, if it is not stopped; keeps the pixels of one that is.
void render_into(Round& round, const PassSource& source, std::uint64_t pass,
                 const PassControl& control, PassImages* unfinished)
{
    const RenderedPass rendered = source.render(pass, control);
    const Stopwatch adding;
    if (rendered.whole)
        add_pass(round.film, pass, rendered.images);
    else if (unfinished != nullptr)
        *unfinished = rendered.images;
    round.costs.film.add(adding);
}

/// The lead's part.
class Lead {
  public:
    Lead(const PassSource& source, const StopRules& rules, const RunControl& control,
         RenderState& state, Ranks& ranks)
        : source_(source), rules_(rules), control_(control), state_(state), ranks_(ranks),
          queue_(rules, control.stop, ranks.count()), begun_(passes()), spent_(state.seconds)
    {
    }

    std::optional<StopReason> reason_to_stop() const
    {
        const std::optional<StopReason> reason = queue_.reason_to_stop(state_.film.passes);
        const bool met = error_is_met(state_, rules_.error);
        return met && reason != StopReason::caller ? StopReason::error : reason;
    }

    void render_round(Round& round)
    {
        queue_.begin_round(state_.film.passes);
        std::thread service([&] {
            ranks_.serve([&](int rank, bool stopped) { return queue_.next(rank, stopped); });
        });
        PassControl pass;
        pass.stop = control_.stop;
        pass.progress = [this](double /*part*/) { tell(); };
        while (const auto number = queue_.next(0, false))
            render_into(round, source_, *number, pass, &unfinished_);
        const Stopwatch waiting;
        service.join();
        round.costs.wait.add(waiting);
    }

    /// Saves and looks, after the films were added up.
    void end_round(RunCosts& costs)
    {
        state_.seconds = spent_ + queue_.seconds();
        const Stopwatch looking;
        if (rules_.error > 0)
            look_at_error(rules_.fireflies, state_);
        costs.film.add(looking);
        if (control_.pass)
            control_.pass(state_);
        if (control_.save && !reason_to_stop())
            control_.save(state_);
    }

    PassImages& unfinished() { return unfinished_; }

  private:
    std::uint64_t passes() const { return count(state_.film.passes); }

    /// The passes after which the rules end the run; none: not known.
    std::optional<double> passes_needed() const
    {
        std::optional<double> out;
        if (rules_.passes != kMostPasses)
            out = static_cast<double>(rules_.passes);
        if (rules_.error > 0 && !state_.checks.empty()) {
            const ErrorLaw law = error_law(state_.checks, state_.radius_decay);
            const double needed = passes_for(law, rules_.error);
            out = std::min(out.value_or(needed), needed);
        }
        return out && std::isfinite(*out) ? out : std::nullopt;
    }

    void tell() const
    {
        if (!control_.progress)
            return;
        const auto rendered = static_cast<double>(queue_.rendered());
        RunProgress progress;
        progress.passes = begun_ + queue_.rendered();
        const std::optional<double> needed = passes_needed();
        if (needed && *needed > static_cast<double>(begun_))
            progress.done = std::min(rendered / (*needed - static_cast<double>(begun_)), 1.0);
        if (std::isfinite(rules_.seconds))
            progress.done = std::max(progress.done.value_or(0), queue_.seconds() / rules_.seconds);
        if (progress.done && *progress.done > 0)
            progress.left = queue_.seconds() * (1 / *progress.done - 1);
        if (!state_.checks.empty())
            progress.error = state_.checks.back().error;
        control_.progress(progress);
    }

    const PassSource& source_;
    const StopRules& rules_;
    const RunControl& control_;
    RenderState& state_;
    Ranks& ranks_;
    PassQueue queue_;
    const std::uint64_t begun_;
    const double spent_; ///< s, before this run
    PassImages unfinished_;
};

RunResult lead(Lead& run, FireflyChoice fireflies, RenderState& state, Ranks& ranks)
{
    look_again(fireflies, state);
    const Film& film = state.film;
    Round round{empty_like(film, film.width, film.height), {}};
    std::optional<StopReason> reason;
    while (!(reason = run.reason_to_stop())) {
        ranks.from_lead(kAnotherRound);
        run.render_round(round);
        collect(round, &state.film, ranks);
        ranks.together([&] { run.end_round(round.costs); });
    }
    ranks.from_lead(static_cast<std::uint64_t>(*reason));
    const Stopwatch ending;
    look_at_error(fireflies, state);
    RunResult out;
    out.reason = *reason;
    set_image(state, std::move(run.unfinished()), out);
    round.costs.film.add(ending);
    out.costs = round.costs;
    return out;
}

RunResult work(const PassSource& source, const RunControl& control, const Film& film, Ranks& ranks)
{
    Round round{empty_like(film, film.width, film.height), {}};
    PassControl pass;
    pass.stop = control.stop;
    std::uint64_t word = 0;
    while ((word = ranks.from_lead(0)) == kAnotherRound) {
        const auto stopped = [&] { return control.stop != nullptr && control.stop->load(); };
        while (const auto number = ranks.ask(stopped()))
            render_into(round, source, *number, pass, nullptr);
        collect(round, nullptr, ranks);
        ranks.together([] {});
    }
    return {static_cast<StopReason>(word), {}, {}, round.costs};
}

} // namespace

RunResult run_ranks(const PassSource& source, const StopRules& rules, const RunControl& control,
                    RenderState& state, Ranks& ranks)
{
    if (!ranks.leads())
        return work(source, control, state.film, ranks);
    Lead run(source, rules, control, state, ranks);
    return lead(run, rules.fireflies, state, ranks);
}

} // namespace hipmap
