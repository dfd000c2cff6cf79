#include "render/integrator/run_passes.h"
#include "tests/render/film/synthetic_passes.h"

#include <catch2/catch.hpp>

#include <map>

using namespace hipmap;

namespace {

/// An integrator whose passes cost nothing.
PassSource source_of(const SyntheticPasses& passes)
{
    PassSource source;
    source.width = source.height = passes.side;
    source.pilot_mean = 1;
    source.bias = passes.radii ? BiasKnowledge::from_radii : BiasKnowledge::unbiased;
    source.render = [passes](std::uint64_t pass, const PassControl& control) {
        const bool stopped = control.stop != nullptr && control.stop->load();
        return RenderedPass{passes.pass(pass), !stopped};
    };
    return source;
}

SyntheticPasses small_passes()
{
    SyntheticPasses passes;
    passes.side = 8;
    return passes;
}

RunResult run(const PassSource& source, const StopRules& rules, RenderState& state)
{
    return run_passes(source, rules, {}, state);
}

} // namespace

TEST_CASE("run: it ends after so many passes, in one run or in many, with the same bits",
          "[integrator]")
{
    const PassSource source = source_of(small_passes());
    RenderState one = begin_state(source, {});
    StopRules rules;
    rules.first_pass = 3;
    rules.passes = 20;
    CHECK(run(source, rules, one).reason == StopReason::passes);
    CHECK(one.film.passes == PassSet{{{3, 23}}});

    RenderState many = begin_state(source, {});
    Image image;
    for (rules.passes = 7; rules.passes <= 20; rules.passes += 13)
        image = run(source, rules, many).image;
    CHECK(many.film == one.film);
    CHECK(image.pixels == film_image(one.film).pixels);
    rules.passes = 20;
    CHECK(run(source, rules, many).reason == StopReason::passes); // nothing left to do
    CHECK(many.film == one.film);
}

TEST_CASE("run: passes that a state holds already are not taken again", "[integrator]")
{
    const PassSource source = source_of(small_passes());
    RenderState state = begin_state(source, {});
    for (const std::uint64_t pass : {1, 2, 5})
        add_pass(state.film, pass, small_passes().pass(pass));
    StopRules rules;
    rules.passes = 7;
    run(source, rules, state);
    CHECK(state.film.passes == PassSet{{{0, 7}}});
}

TEST_CASE("resume_state: it takes the film, and refuses one that begin_state does not make",
          "[integrator]")
{
    PassSource source = source_of(small_passes());
    RenderState found = begin_state(source, {});
    add_pass(found.film, 1, small_passes().pass(1));
    const std::int64_t* const sums = found.film.radiance.data();
    RenderState state = resume_state(source, std::move(found), "a.state");
    CHECK(state.film.radiance.data() == sums);
    CHECK(state.film.passes == PassSet{{{1, 2}}});
    source.pilot_mean = 4; // another unit
    CHECK_THROWS_AS(resume_state(source, state, "a.state"), InputError);
    source.pilot_mean = 1;
    source.allocation = 7;
    CHECK_THROWS_AS(resume_state(source, state, "a.state"), InputError);
    source.allocation = 0;
    source.clamped = true;
    CHECK_THROWS_AS(resume_state(source, state, "a.state"), InputError);
}

TEST_CASE("run: an error ends it at a check, where it is met and was not before", "[integrator]")
{
    SyntheticPasses passes = small_passes();
    passes.radii = false;
    const PassSource source = source_of(passes);
    RenderState state = begin_state(source, {});
    StopRules rules;
    rules.error = 0.05;
    CHECK(run(source, rules, state).reason == StopReason::error);
    const auto& checks = state.checks;
    REQUIRE(checks.size() > 6);
    CHECK(checks.back().error.error <= 0.05);
    std::uint64_t passes_at = 0;
    for (std::size_t i = 0; i < checks.size(); ++i) {
        CHECK((checks[i].error.error <= 0.05) == (i + 1 == checks.size()));
        CHECK(checks[i].passes == (passes_at = next_look(passes_at)));
    }
    CHECK(next_check(passes_at - 1) == passes_at);
    CHECK(count(state.film.passes) == passes_at);
    CHECK(run(source, rules, state).reason == StopReason::error); // met already
    CHECK(count(state.film.passes) == passes_at);
}

TEST_CASE("run: at least one pass is done in no time, and none is begun without any",
          "[integrator]")
{
    const PassSource source = source_of(small_passes());
    RenderState state = begin_state(source, {});
    StopRules rules;
    rules.seconds = 0;
    CHECK(run(source, rules, state).reason == StopReason::time);
    CHECK(count(state.film.passes) == 1);
    rules.passes = 0;
    RenderState empty = begin_state(source, {});
    const RunResult result = run(source, rules, empty);
    CHECK(result.reason == StopReason::passes);
    CHECK(result.image.pixels == std::vector<Rgb>(64));
}

TEST_CASE("run: what the caller hears goes from nothing to all, and a stop ends it", "[integrator]")
{
    const PassSource source = source_of(small_passes());
    PassSource talking = source;
    talking.render = [&source](std::uint64_t pass, const PassControl& control) {
        for (const double part : {0.0, 0.5, 1.0})
            control.progress(part);
        return source.render(pass, control);
    };
    std::atomic<bool> stop{false};
    std::vector<double> heard;
    RunControl control;
    control.stop = &stop;
    control.progress = [&](const RunProgress& progress) {
        heard.push_back(progress.done.value());
        CHECK(progress.error.has_value() == (progress.passes >= 2));
    };
    RenderState state = begin_state(source, {});
    StopRules rules;
    rules.passes = 10;
    run_passes(talking, rules, control, state);
    CHECK(std::is_sorted(heard.begin(), heard.end()));
    CHECK(heard.front() == 0);
    CHECK(heard.back() == 1);

    control.progress = [&](const RunProgress& progress) { stop = progress.passes == 12; };
    rules.passes = 20;
    const RunResult stopped = run_passes(talking, rules, control, state);
    CHECK(stopped.reason == StopReason::caller);
    CHECK(state.film.passes == PassSet{{{0, 12}}});
    CHECK(stopped.image.pixels == film_image(state.film).pixels);
    CHECK(state.checks.back().passes == 12);
}

TEST_CASE("run: no share is told of an error until it was looked at twice, then one to the check "
          "that will meet it",
          "[integrator]")
{
    SyntheticPasses passes = small_passes();
    passes.radii = false; // the error falls as 1 / sqrt(N), so that the law is right
    const PassSource source = source_of(passes);
    PassSource talking = source;
    talking.render = [&source](std::uint64_t pass, const PassControl& control) {
        control.progress(0);
        return source.render(pass, control);
    };
    StopRules rules;
    rules.error = 0.05;
    std::map<std::uint64_t, std::optional<double>> told;
    RunControl control;
    control.progress = [&](const RunProgress& progress) { told[progress.passes] = progress.done; };
    RenderState state = begin_state(source, {});
    run_passes(talking, rules, control, state);
    const auto end = static_cast<double>(count(state.film.passes));
    for (const auto& [at, share] : told) {
        CHECK(share.has_value() == (at >= 3));
        if (share && 2 * at > end) // a step of the checks is a factor of 1.4
            CHECK(*share == Approx(static_cast<double>(at) / end).epsilon(0.45));
        if (share)
            CHECK(*share <= 1);
    }

    // Another rule is known from the beginning.
    rules.passes = 4;
    told.clear();
    RenderState short_state = begin_state(source, {});
    run_passes(talking, rules, control, short_state);
    CHECK(told[1].value() == Approx(0.25));
}
