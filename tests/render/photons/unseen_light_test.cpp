#include "common/math/random.h"
#include "render/photons/trace_photons.h"
#include "render/photons/unseen_light.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>
#include <tbb/global_control.h>

#include <cmath>

using namespace hipmap;

namespace {

/// Regions of one kind: all of one side of a map.
SeenRegions whole_side(MapId map, std::uint8_t side, float worth)
{
    SeenRegions out;
    out.sides = {SeenRegions::side_of(map, side)};
    out.roots = {0};
    out.nodes.resize(1);
    out.regions.resize(1);
    out.regions[0].box.low = glm::vec3(-1e6f);
    out.regions[0].box.high = glm::vec3(1e6f);
    out.regions[0].worth = worth;
    out.mean_worth = double{worth};
    return out;
}

PhotonOptions photon_options(const SeenSurfaces& seen)
{
    PhotonOptions out;
    out.paths = 20000;
    out.store_direct = true;
    out.caustic_paths = 5000;
    out.seen = &seen;
    return out;
}

/// The counts of photons by hand: paths that left one on the floor, and their power.
struct ByHand {
    std::uint64_t paths = 0;
    double power = 0;
};

ByHand count_by_hand(const TracedPhotons& traced, const Partition& partition, MapId map)
{
    ByHand out;
    std::uint64_t begin = 0;
    for (const PhotonCounts& after : traced.after_path) {
        bool reached = false;
        for (std::uint64_t i = begin; i < after.global; ++i) {
            const Photon& photon = traced.global[i];
            if (partition.map_of(photon.face) != map || photon.side != 0)
                continue;
            reached = true;
            out.power += double{photon.power.x} + double{photon.power.y} + double{photon.power.z};
        }
        begin = after.global;
        out.paths += reached ? 1 : 0;
    }
    return out;
}

/// Counts of paths that reach classes, one of each light, by Poisson's distribution about the
/// expected numbers; each photon is worth one unit.
SeenClasses draw_classes(const std::vector<double>& expected, RandomSequence& random)
{
    SeenClasses out;
    out.classes.resize(SeenClasses::kClasses);
    out.passes = 1;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        double left = std::exp(-expected[i]); // Knuth's method
        std::uint32_t count = 0;
        for (double product = double{random.next()}; product > left;
             product *= double{random.next()})
            ++count;
        out.classes[i] = {count, static_cast<std::uint32_t>(i), count};
        out.lights.push_back({.paths = count, .global = 1});
        out.worth += count;
    }
    return out;
}

} // namespace

TEST_CASE("seen classes: light paths that reach a seen side of a map are counted", "[photons]")
{
    const auto ready = tiny::ready(tiny::room());
    const MapId map = ready->partition.map_of(0);
    const SeenSurfaces seen{
        ready->render->mesh(), ready->partition, {}, whole_side(map, 0, 1), 1, 1e-6};
    PhotonOptions options = photon_options(seen);
    options.caustic_paths = 0;
    options.light.caustic = false;
    options.count_paths = true;
    // Of many paths some stand for others.
    for (const auto& [paths, off] : {std::pair(60, 1e-4), std::pair(100000, 0.03)}) {
        options.paths = static_cast<std::uint64_t>(paths);
        const TracedPhotons traced = trace_photons(*ready->render, options);
        const ByHand by_hand = count_by_hand(traced, ready->partition, map);
        REQUIRE(by_hand.paths > 0);
        const auto found = static_cast<double>(count_paths(traced.seen));
        CHECK(found == Approx(static_cast<double>(by_hand.paths)).epsilon(off));
        CHECK(static_cast<double>(traced.seen.worth) * seen.unit ==
              Approx(by_hand.power).epsilon(off));
    }
}

TEST_CASE("seen classes: counts do not depend on the number of threads or the order of passes",
          "[photons]")
{
    const auto ready = tiny::ready(tiny::room());
    const MapId map = ready->partition.map_of(0);
    const SeenSurfaces seen{ready->render->mesh(),
                            ready->partition,
                            whole_side(map, 0, 2),
                            whole_side(map, 0, 1),
                            1,
                            1e-6};
    const auto count = [&](std::uint64_t pass, int threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                        static_cast<std::size_t>(threads));
        PhotonOptions options = photon_options(seen);
        options.pass = pass;
        return trace_photons(*ready->render, options).seen;
    };
    const auto same = [](const SeenClasses& a, const SeenClasses& b) {
        REQUIRE(a.classes.size() == b.classes.size());
        REQUIRE(a.lights.size() == b.lights.size());
        bool equal = a.worth == b.worth;
        for (std::size_t i = 0; i < a.lights.size(); ++i)
            equal = equal && a.lights[i].paths == b.lights[i].paths &&
                    a.lights[i].caustic == b.lights[i].caustic &&
                    a.lights[i].global == b.lights[i].global;
        for (std::size_t i = 0; i < a.classes.size(); ++i)
            equal = equal && a.classes[i].paths == b.classes[i].paths &&
                    a.classes[i].worth == b.classes[i].worth;
        CHECK(equal);
    };
    const SeenClasses first = count(0, 1), second = count(1, 1);
    REQUIRE(!first.lights.empty());
    REQUIRE(first.lights[0].caustic > 0);
    same(first, count(0, 2));
    same(first, count(0, 7));
    SeenClasses forth = first, back = second;
    merge(forth, second);
    merge(back, first);
    same(forth, back);
}

TEST_CASE("unseen light: the share of classes met once estimates that of classes not met",
          "[photons]")
{
    // 600 classes, of which about half are met.
    std::vector<double> expected;
    for (int i = 0; i < 600; ++i)
        expected.push_back(0.2 + 0.002 * i);
    double estimated = 0, unseen = 0;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        RandomSequence random(seed, RandomStream::photons, 0, 0);
        const SeenClasses drawn = draw_classes(expected, random);
        const auto found = find_unseen_light(drawn, {.unit = 1, .global_worth = 1});
        REQUIRE(found);
        estimated += found->share * static_cast<double>(drawn.worth);
        for (std::size_t i = 0; i < expected.size(); ++i)
            unseen += drawn.classes[i].paths == 0 ? expected[i] : 0;
    }
    CHECK(estimated == Approx(unseen).epsilon(0.02));
}

TEST_CASE("unseen light: its upper limit holds 95 times of 100", "[photons]")
{
    constexpr int kSeeds = 2000;
    const std::vector<std::vector<double>> scenes = {
        {1.0, 50}, {2.9, 50}, {3.3, 50}, {1.0, 1.5, 50}, std::vector<double>(200, 0.05)};
    for (const std::vector<double>& expected : scenes) {
        int held = 0;
        for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
            RandomSequence random(seed, RandomStream::photons, 0, 0);
            const SeenClasses drawn = draw_classes(expected, random);
            const auto found = find_unseen_light(drawn, {.unit = 1, .global_worth = 1});
            double unseen = 0;
            for (std::size_t i = 0; i < expected.size(); ++i)
                unseen += drawn.classes[i].paths == 0 ? expected[i] : 0;
            held += found->most * static_cast<double>(drawn.worth) >= unseen ? 1 : 0;
        }
        CHECK(held >= 0.95 * kSeeds);
    }
}

TEST_CASE("unseen light: an image of no light, and passes that were not counted", "[photons]")
{
    const SeenScale scale{.unit = 1, .global_worth = 1};
    CHECK(!find_unseen_light({}, scale));
    SeenClasses dark;
    dark.passes = 4;
    CHECK(find_unseen_light(dark, scale)->most == 0); // no light emits
    CHECK(share_of_path(dark, scale) == 0);
    dark.lights = {{}, {.global = 2}};
    const auto found = find_unseen_light(dark, scale);
    REQUIRE(found);
    CHECK(std::isinf(found->most));
    CHECK(found->share == 0);
    CHECK(found->light == 1);
    CHECK(found->never);
}
