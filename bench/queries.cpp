// What a search for the k nearest photons costs, by method: ns a query on one thread, and how many
// times less than nanoflann's; checks that all methods find the same photons.  The last column adds
// the sum of their powers, which irradiance needs.  Bytes are those of a method's tree and
// positions; of the wide tree, all that is kept of a photon.  Of the wide tree also: the nodes,
// blocks and bytes that a search reads (nodes above its last level are shared by searches near each
// other and not counted), and which share of its time they would take at the speed of L2, L3 and
// DRAM, and its arithmetic at that of the processor: a roofline.
//
//     queries [PHOTONS...] [--neighbours K...] [--simd TARGET]     default: 50000 1000000, all K

#include "bench/fixed_radius.h"
#include "bench/query_methods.h"
#include "common/command_line/command_line.h"
#include "common/math/random.h"
#include "render/maps/wide_search.h"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <string>

namespace hipmap {

namespace {

using Points = std::vector<RoomPoint>;

/// Consecutive queries that are measured together, and how many such runs are.
constexpr std::size_t kRun = 256;
constexpr std::size_t kRuns = 32;
constexpr int kRounds = 5;
constexpr std::size_t kChecked = 32;

/// Queries of a whole picture in an order, and what ordering them cost for each.
struct QueryOrder {
    const char* name;
    Points queries; ///< some of them
    double seconds_each = 0;
    Points all = {}; ///< in random order alone
};

/// Returns the processor time since `start`, in seconds.
double seconds_since(std::clock_t start)
{
    return double(std::clock() - start) / CLOCKS_PER_SEC;
}

/// Evenly spaced runs of consecutive queries: as near to each other as in the whole picture.
Points sample_runs(const Points& all)
{
    Points out;
    for (std::size_t run = 0; run < kRuns; ++run) {
        const std::size_t begin = run * (all.size() - kRun) / (kRuns - 1);
        out.insert(out.end(), all.begin() + static_cast<std::ptrdiff_t>(begin),
                   all.begin() + static_cast<std::ptrdiff_t>(begin + kRun));
    }
    return out;
}

std::vector<QueryOrder> make_orders()
{
    const Points rows = room_picture(1024, 768);
    Points shuffled = rows;
    for (std::size_t i = shuffled.size(); i-- > 1;) {
        RandomSequence random(2, RandomStream::pictures, 0, i);
        std::swap(shuffled[i], shuffled[static_cast<std::size_t>(random.next() * float(i + 1))]);
    }
    Points sorted = shuffled;
    const std::clock_t start = std::clock();
    sort_by_morton_code(sorted);
    const double each = seconds_since(start) / double(sorted.size());
    return {{"scanline", sample_runs(rows), 0},
            {"random", sample_runs(shuffled), 0, shuffled},
            {"sorted", sample_runs(sorted), each}};
}

/// Returns the time of a search, and of the sum of the powers it found if `sum`.
double nanoseconds(QueryMethod& method, const QueryOrder& order, bool sum)
{
    double best = std::numeric_limits<double>::infinity();
    for (int i = 0; i < kRounds; ++i) {
        const std::clock_t start = std::clock(); // of this program, whatever else runs
        for (const RoomPoint& query : order.queries) {
            if (sum)
                method.sum(query);
            else
                method.search(query);
        }
        best = std::min(best, seconds_since(start) / double(order.queries.size()));
    }
    return 1e9 * (best + order.seconds_each);
}

/// Square distances and numbers, ordered; the numbers are left out if a method does not order them.
using Found = std::vector<std::pair<float, std::uint32_t>>;

Found ordered(const Points& photons, const RoomPoint& query,
              const std::vector<std::uint32_t>& found, bool numbers)
{
    Found out;
    for (const std::uint32_t photon : found) {
        const glm::vec3 d = photons[photon].position - query.position;
        out.emplace_back(glm::dot(d, d), numbers ? photon : 0);
    }
    std::sort(out.begin(), out.end());
    return out;
}

Found brute_force(const Points& photons, const RoomPoint& query, std::size_t k, bool by_map)
{
    Found out;
    for (std::uint32_t i = 0; i < photons.size(); ++i) {
        const glm::vec3 d = photons[i].position - query.position;
        if (!by_map || photons[i].map == query.map)
            out.emplace_back(glm::dot(d, d), i);
    }
    const std::size_t count = std::min(k, out.size());
    std::partial_sort(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(count), out.end());
    out.resize(count);
    return out;
}

/// How many searches of a method differ from the first method that searches the same photons.
std::size_t count_differences(const Points& photons, QueryMethod& method, QueryMethod& reference,
                              const Points& queries)
{
    std::size_t different = 0;
    const bool numbers = method.breaks_ties() && reference.breaks_ties();
    for (const RoomPoint& query : queries) {
        method.search(query);
        reference.search(query);
        different += ordered(photons, query, method.found(), numbers) !=
                     ordered(photons, query, reference.found(), numbers);
    }
    return different;
}

std::size_t count_wrong(const Points& photons, QueryMethod& method, const Points& queries,
                        std::size_t k)
{
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < kChecked; ++i) {
        const RoomPoint& query = queries[i * queries.size() / kChecked];
        Found truth = brute_force(photons, query, k, method.by_map());
        if (!method.breaks_ties())
            for (auto& [distance2, photon] : truth)
                photon = 0;
        method.search(query);
        const bool found = ordered(photons, query, method.found(), method.breaks_ties()) == truth;
        wrong += found && method.sum_is_right(query) ? 0 : 1;
    }
    return wrong;
}

/// A line of the table; `first` has what the first method took.
void print_times(QueryMethod& method, const std::vector<QueryOrder>& orders,
                 std::vector<double>& first)
{
    std::printf("%-26s", method.name());
    for (std::size_t i = 0; i <= orders.size(); ++i) {
        const bool sum = i == orders.size();
        const double ns = nanoseconds(method, orders[sum ? 0 : i], sum);
        if (first.size() <= i)
            first.push_back(ns);
        std::printf(" %9.0f (%6.1f)", ns, first[i] / ns);
    }
}

/// Prints what searches with the sum read in an order, where that is counted.
void print_traffic(QueryMethod& method, const QueryOrder& order, const MachineLimits& limits)
{
    Traffic sum;
    for (const RoomPoint& query : order.queries) {
        method.sum(query);
        const std::optional<Traffic> one = method.traffic();
        if (!one)
            return;
        sum += *one;
    }
    const double each = 1 / double(order.queries.size());
    const Traffic mean{sum.nodes * each, sum.blocks * each, sum.whole * each, sum.bytes * each,
                       sum.operations * each};
    const std::string name = std::string(method.name()) + ", " + order.name;
    print_roofline(name.c_str(), mean, nanoseconds(method, order, true), limits);
}

void print_limits(const MachineLimits& limits)
{
    std::printf("one thread reads %.0f GB/s from L2, %.0f from L3, %.0f from DRAM, and makes %.0f "
                "billion float additions and multiplications a second\n",
                1e-9 * limits.l2, 1e-9 * limits.l3, 1e-9 * limits.dram, 1e-9 * limits.operations);
}

/// Returns whether every method found what it should.
bool measure(const Points& photons, std::vector<BuiltMethod>& methods,
             const std::vector<QueryOrder>& orders, const MachineLimits& limits, std::size_t k)
{
    std::printf("\n%zu photons, k = %zu: ns a query (times faster than the first)\n%-26s",
                photons.size(), k, "");
    for (const QueryOrder& order : orders)
        std::printf(" %18s", order.name);
    std::printf(" %18s   differ  wrong\n", "scanline and sum");
    std::vector<double> first;
    bool right = true;
    for (BuiltMethod& built : methods) {
        QueryMethod& method = *built.method;
        method.prepare(k);
        print_times(method, orders, first);
        BuiltMethod& reference = *std::find_if(methods.begin(), methods.end(), [&](const auto& m) {
            return m.method->by_map() == method.by_map() && m.method->breaks_ties();
        });
        reference.method->prepare(k);
        const std::size_t different =
            count_differences(photons, method, *reference.method, orders[0].queries);
        const std::size_t wrong = count_wrong(photons, method, orders[1].queries, k);
        std::printf(" %8zu %6zu\n", different, wrong);
        right = right && different == 0 && wrong == 0;
    }
    std::printf("searches with the sum, beside the limits of the machine:\n");
    for (const BuiltMethod& built : methods)
        for (const QueryOrder& order : orders)
            print_traffic(*built.method, order, limits);
    return right;
}

/// Makes a different power for each photon.
Powers make_powers(std::size_t count)
{
    Powers powers;
    for (std::size_t i = 0; i < count; ++i)
        powers.emplace_back(1.0f + float(i) / float(count));
    return powers;
}

int measure_queries(const std::vector<std::size_t>& sizes, const std::vector<std::size_t>& wanted)
{
    limit_threads(1);
    const std::vector<QueryOrder> orders = make_orders();
    const MachineLimits limits = measure_machine();
    print_limits(limits);
    bool right = true;
    for (const std::size_t size : sizes) {
        const Points photons = room_photons(size);
        const Powers powers = make_powers(size);
        std::vector<BuiltMethod> methods = build_methods(photons, powers);
        std::printf("\n%zu photons: ns a photon to build (times faster), bytes a photon\n", size);
        for (const BuiltMethod& built : methods)
            std::printf("%-26s %9.0f (%6.1f) %9.1f\n", built.method->name(),
                        1e9 * built.build_seconds / double(size),
                        methods[0].build_seconds / built.build_seconds,
                        double(built.method->bytes()) / double(size));
        right = measure_fixed_radius(photons, orders[1].queries, orders[1].all) && right;
        for (const std::size_t k : wanted)
            right = measure(photons, methods, orders, limits, k) && right;
    }
    std::printf("\n%s\n", right ? "every method found the same photons, brute force too"
                                : "NOT every method found the same photons");
    return right ? kExitDone : kExitDefect;
}

} // namespace

} // namespace hipmap

int main(int argc, char** argv)
{
    return hipmap::run_tool([&] {
        std::vector<std::size_t> sizes{50000, 1000000}, wanted{25, 50, 150, 300, 600};
        std::string simd = hipmap::simd_targets().front();
        CLI::App app("Measures what a search for the nearest photons costs, by method.", "queries");
        app.add_option("PHOTONS", sizes, "How many photons [50000 1000000]")
            ->check(CLI::Range(1, 1 << 30));
        app.add_option("--neighbours", wanted, "How many are wanted [25 50 150 300 600]")
            ->check(CLI::Range(1, 1 << 20));
        app.add_option("--simd", simd, "Kernel of the wide tree [the best there is]")
            ->check(CLI::IsMember(hipmap::simd_targets()));
        if (const std::optional<int> code = hipmap::parse_arguments(app, argc, argv))
            return *code;
        hipmap::use_simd_target(simd.c_str());
        std::printf("wide tree by %s\n", simd.c_str());
        return hipmap::measure_queries(sizes, wanted);
    });
}
