#include "bench/machine_limits.h"

#include <cstdio>
#include <ctime>
#include <limits>
#include <vector>

// foreach_target compiles what follows it once for each instruction set.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "bench/machine_limits.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace hipmap::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Reads all numbers in order; four sums, so that none waits for the other.
float ReadAll(const float* from, std::size_t count)
{
    const hn::CappedTag<float, 16> d;
    const std::size_t lanes = hn::Lanes(d);
    auto a = hn::Zero(d), b = a, c = a, e = a;
    for (std::size_t i = 0; i + 4 * lanes <= count; i += 4 * lanes) {
        a = hn::Max(a, hn::LoadU(d, from + i));
        b = hn::Max(b, hn::LoadU(d, from + i + lanes));
        c = hn::Max(c, hn::LoadU(d, from + i + 2 * lanes));
        e = hn::Max(e, hn::LoadU(d, from + i + 3 * lanes));
    }
    return hn::GetLane(hn::MaxOfLanes(d, hn::Max(hn::Max(a, b), hn::Max(c, e))));
}

/// Multiplies and adds in eight chains; returns the number of operations.
double Calculate(float by, std::size_t rounds, float& out)
{
    const hn::CappedTag<float, 16> d;
    const auto factor = hn::Set(d, by), term = hn::Set(d, 1.0f);
    constexpr int kChains = 8;
    auto a = term, b = term, c = term, e = term, f = term, g = term, h = term, i = term;
    const auto step = [&](auto& of) HWY_ATTR { of = hn::Add(hn::Mul(of, factor), term); };
    for (std::size_t round = 0; round < rounds; ++round) {
        step(a), step(b), step(c), step(e);
        step(f), step(g), step(h), step(i);
    }
    const auto sum =
        hn::Add(hn::Add(hn::Add(a, b), hn::Add(c, e)), hn::Add(hn::Add(f, g), hn::Add(h, i)));
    out = hn::GetLane(hn::SumOfLanes(d, sum));
    return 2.0 * kChains * static_cast<double>(hn::Lanes(d)) * static_cast<double>(rounds);
}

} // namespace hipmap::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hipmap {

HWY_EXPORT(ReadAll);
HWY_EXPORT(Calculate);

namespace {

/// So that nothing measured is left out as unused.
volatile float used;

/// Returns the least time that one of some runs takes, in seconds of the processor.
template <typename Run>
double best_time(const Run& run)
{
    double best = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 7; ++i) {
        const std::clock_t start = std::clock(); // of this program, whatever else runs
        run();
        best = std::min(best, double(std::clock() - start) / CLOCKS_PER_SEC);
    }
    return best;
}

double bytes_a_second(std::size_t bytes)
{
    const std::vector<float> array(bytes / sizeof(float), 1.0f);
    const std::size_t rounds = std::max<std::size_t>(1, (std::size_t{64} << 20) / bytes);
    const double seconds = best_time([&] {
        for (std::size_t round = 0; round < rounds; ++round)
            used = HWY_DYNAMIC_DISPATCH(ReadAll)(array.data(), array.size());
    });
    return static_cast<double>(bytes * rounds) / seconds;
}

} // namespace

MachineLimits measure_machine()
{
    MachineLimits out;
    out.l2 = bytes_a_second(std::size_t{512} << 10);
    out.l3 = bytes_a_second(std::size_t{8} << 20);
    out.dram = bytes_a_second(std::size_t{256} << 20);
    double operations = 0;
    const double seconds = best_time([&] {
        float result = 0;
        operations = HWY_DYNAMIC_DISPATCH(Calculate)(used - 0.5f, 1 << 21, result);
        used = 1.0f + 0 * result;
    });
    out.operations = operations / seconds;
    return out;
}

Traffic& Traffic::operator+=(const Traffic& more)
{
    nodes += more.nodes;
    blocks += more.blocks;
    whole += more.whole;
    bytes += more.bytes;
    operations += more.operations;
    return *this;
}

void print_roofline(const char* name, const Traffic& mean, double nanoseconds,
                    const MachineLimits& limits)
{
    const auto share = [&](double amount, double a_second) {
        return 100 * 1e9 * amount / a_second / nanoseconds;
    };
    std::printf("%-26s %6.1f nodes %6.1f blocks %6.1f by power alone %8.0f bytes: %4.0f %% of the "
                "time in L2, %4.0f %% L3, %4.0f %% DRAM, %4.0f %% arithmetic\n",
                name, mean.nodes, mean.blocks, mean.whole, mean.bytes, share(mean.bytes, limits.l2),
                share(mean.bytes, limits.l3), share(mean.bytes, limits.dram),
                share(mean.operations, limits.operations));
}

} // namespace hipmap
#endif
