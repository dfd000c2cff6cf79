#include "render/many/pass_queue.h"

#include <catch2/catch.hpp>

#include <thread>

using namespace hipmap;

namespace {

constexpr int kRanks = 3;

/// Takes the passes of a round, by ranks in turn.
PassSet take_round(PassQueue& queue, const PassSet& held)
{
    queue.begin_round(held);
    PassSet out;
    std::uint64_t last = 0;
    for (int rank = 0;; rank = (rank + 1) % kRanks) {
        const auto pass = queue.next(rank, false);
        if (!pass)
            return out;
        CHECK(*pass >= last); // in order
        CHECK_FALSE(common_pass(out, {{{*pass, *pass + 1}}}));
        out = united(out, {{{*pass, *pass + 1}}});
        last = *pass;
    }
}

} // namespace

TEST_CASE("pass queue: ranks get each missing pass once, to the number asked for", "[many]")
{
    StopRules rules;
    rules.passes = 10;
    rules.first_pass = 2;
    PassQueue queue(rules, nullptr, kRanks);
    const PassSet held = {{{4, 6}}};
    CHECK_FALSE(queue.reason_to_stop(held));
    const PassSet round = take_round(queue, held);
    CHECK(round == PassSet{{{2, 4}, {6, 12}}});
    CHECK(queue.reason_to_stop(united(held, round)) == StopReason::passes);
}

TEST_CASE("pass queue: rounds end where one process would look at the error", "[many]")
{
    StopRules rules;
    rules.error = 0.01;
    rules.passes = 20;
    PassQueue queue(rules, nullptr, kRanks);
    PassSet held;
    while (!queue.reason_to_stop(held)) {
        const std::uint64_t before = count(held);
        held = united(held, take_round(queue, held));
        CHECK(count(held) == std::min<std::uint64_t>(next_check(before), 20));
    }
    CHECK(held == PassSet{{{0, 20}}});
}

TEST_CASE("pass queue: all ranks end when one must stop, or the time is over", "[many]")
{
    StopRules rules;
    PassQueue stopped(rules, nullptr, kRanks);
    stopped.begin_round({});
    CHECK(stopped.next(0, false) == std::uint64_t{0});
    CHECK_FALSE(stopped.next(1, true));
    CHECK_FALSE(stopped.next(2, false));
    CHECK(stopped.reason_to_stop({{{0, 1}}}) == StopReason::caller);

    rules.seconds = 0.05;
    PassQueue timed(rules, nullptr, 1);
    timed.begin_round({});
    CHECK(timed.next(0, false));
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    CHECK_FALSE(timed.next(0, false)); // another would not be over in time
    CHECK(timed.rendered() == 1);
    CHECK(timed.reason_to_stop({{{0, 1}}}) == StopReason::time);

    const std::atomic<bool> stop{true};
    const StopRules none;
    PassQueue told(none, &stop, 1);
    told.begin_round({});
    CHECK_FALSE(told.next(0, false));
}

TEST_CASE("pass queue: threads that take passes at once get each once", "[many]")
{
    StopRules rules;
    rules.passes = 2000;
    PassQueue queue(rules, nullptr, kRanks);
    queue.begin_round({});
    std::vector<PassSet> taken(kRanks);
    std::vector<std::thread> threads;
    for (int rank = 0; rank < kRanks; ++rank)
        threads.emplace_back([&, rank] {
            PassSet& own = taken[static_cast<std::size_t>(rank)];
            while (const auto pass = queue.next(rank, false))
                own = united(own, {{{*pass, *pass + 1}}});
        });
    for (std::thread& thread : threads)
        thread.join();
    PassSet all;
    for (const PassSet& own : taken) {
        CHECK_FALSE(common_pass(all, own));
        all = united(all, own);
    }
    CHECK(all.ranges.size() == 1);
}
