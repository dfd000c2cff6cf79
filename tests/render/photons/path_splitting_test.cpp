#include "render/photons/path_splitting.h"
#include "render/photons/trace_photons.h"
#include "tests/support/one_map.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

/// Records on one face: for x below zero one of ten is worth ten, beyond it all are worth one.
std::vector<SplitRecord> uneven_records()
{
    std::vector<SplitRecord> out;
    RandomSequence random(1, RandomStream::pictures, 0, 0);
    for (int i = 0; i < 20000; ++i) {
        const float x = 2 * random.next() - 1;
        const float rare = random.next() < 0.1f ? 10.0f : 0.0f;
        out.push_back({{{x, 0, random.next()}, 0, 0}, x < 0 ? rare : 1.0f});
    }
    return out;
}

/// Splits wherever a path arrives with this share of the mean power or more.
PathSplitting everywhere(const Partition& partition, double emitted, double share)
{
    PathSplitting out;
    for (std::uint64_t side = 0; side < 2 * std::uint64_t{partition.all_map_count()}; ++side) {
        out.deviation.sides.push_back(side);
        out.deviation.roots.push_back(0);
    }
    out.deviation.nodes.push_back({});
    out.deviation.values.push_back(2);
    out.most = 2;
    out.usual = emitted * share;
    return out;
}

double power_of(const std::vector<Photon>& photons)
{
    double out = 0;
    for (const Photon& photon : photons)
        out += double{photon.power.x + photon.power.y + photon.power.z};
    return out;
}

} // namespace

TEST_CASE("path splitting: paths split where what they are worth varies", "[photons]")
{
    std::vector<SplitRecord> records = uneven_records();
    const Partition partition = tiny::one_map();
    const PathSplitting splitting = learn_splitting(partition, records, 1);
    const Place rare{{-0.5f, 0, 0.5f}, 0, 0}, even{{0.5f, 0, 0.5f}, 0, 0};
    const float* const deviation = value_at(splitting.deviation, partition, rare);
    REQUIRE(deviation != nullptr);
    CHECK(*deviation == Approx(3).margin(1.5)); // sqrt(0.1 * 100 - 1), of 64 to 127 records
    CHECK(*value_at(splitting.deviation, partition, even) == Approx(0).margin(1e-3));
    CHECK(splits_at(splitting, partition, even, 100, 1) == 1);
    CHECK(splits_at(splitting, partition, rare, 0.1, 1) == 1);
    CHECK(splits_at(splitting, partition, rare, 8, 1) == std::lround(8 * *deviation));
    CHECK(splits_at(splitting, partition, rare, 1e6, 1) == kMostSplits);
    CHECK(splits_at(splitting, partition, rare, 1e6, 40) == 1);
    CHECK(splits_at(splitting, partition, {rare.position, 0, 1}, 1e6, 1) == 1); // the other side
    CHECK(splits_at(splitting, partition, rare, std::nan(""), 1) == 1);
}

TEST_CASE("path splitting: what it saves is what one path would vary by more", "[photons]")
{
    std::vector<SplitRecord> records = uneven_records();
    const Partition partition = tiny::one_map();
    const PathSplitting splitting = learn_splitting(partition, records, 1);
    const Place rare{{-0.5f, 0, 0.5f}, 0, 0}, even{{0.5f, 0, 0.5f}, 0, 0};
    const double variance = std::pow(double{*value_at(splitting.deviation, partition, rare)}, 2);
    // Eight of power 2 stand for one of power 16: 256 V - 8 * 4 V.
    const std::vector<SplitRecord> split(8, {rare, 0, 2, 8});
    CHECK(square_saved(splitting, partition, split) == Approx(224 * variance));
    CHECK(square_saved(splitting, partition, std::vector<SplitRecord>(8, {rare, 0, 2, 1})) == 0);
    CHECK(square_saved(splitting, partition, std::vector<SplitRecord>(8, {even, 0, 2, 8})) ==
          Approx(0).margin(1e-3));
    CHECK(square_saved({}, partition, split) == 0);
}

TEST_CASE("path splitting: without records, or where nothing is worth anything, none", "[photons]")
{
    const Partition partition = tiny::one_map();
    const Place place{{0.5f, 0, 0.5f}, 0, 0};
    std::vector<SplitRecord> none, some = uneven_records();
    CHECK(splits_at(learn_splitting(partition, none, 1), partition, place, 1e6, 1) == 1);
    const PathSplitting dark = learn_splitting(partition, some, 0);
    CHECK(dark.usual == 0);
    CHECK(splits_at(dark, partition, place, 1e6, 1) == 1);
}

TEST_CASE("path splitting: photons carry the same light, and no power is lost", "[photons]")
{
    const auto ready = tiny::ready(tiny::room());
    PhotonOptions options{.paths = 4096, .seed = 1};
    const TracedPhotons first = trace_photons(*ready->render, options);
    const double emitted = first.power.emitted.x + first.power.emitted.y + first.power.emitted.z;
    PhotonGuides guides{even_guide(ready->render->lights, Emitters::all),
                        even_guide(ready->render->lights, Emitters::all)};
    RunningMean split, whole, left;
    std::size_t photons = 0, split_photons = 0;
    for (options.pass = 0; options.pass < 64; ++options.pass) {
        options.guides = &guides;
        guides.splitting = {};
        const TracedPhotons plain = trace_photons(*ready->render, options);
        guides.splitting = everywhere(ready->partition, emitted, 0.2);
        const TracedPhotons more = trace_photons(*ready->render, options);
        const glm::dvec3 ends = more.power.absorbed + more.power.escaped;
        left.add(ends.x + ends.y + ends.z);
        whole.add(power_of(plain.global));
        split.add(power_of(more.global));
        photons += plain.global.size();
        split_photons += more.global.size();
        CHECK(more.cut == 0);
    }
    CHECK(split_photons > 2 * photons);
    const double noise = std::hypot(split.standard_error(), whole.standard_error());
    CHECK(std::abs(split.mean() - whole.mean()) < kMostZ * noise);
    CHECK(noise < 0.01 * whole.mean());
    CHECK(std::abs(left.z_score(emitted)) < kMostZ);
}

TEST_CASE("path splitting: arrivals tell what each path left from there on", "[photons]")
{
    const auto ready = tiny::ready(tiny::room());
    PhotonOptions options{.paths = 4096, .seed = 1, .count_paths = true, .keep_arrivals = true};
    PhotonGuides guides{even_guide(ready->render->lights, Emitters::all),
                        even_guide(ready->render->lights, Emitters::all)};
    const TracedPhotons plain = trace_photons(*ready->render, options);
    const double emitted = plain.power.emitted.x + plain.power.emitted.y + plain.power.emitted.z;
    guides.splitting = everywhere(ready->partition, emitted, 0.2);
    options.guides = &guides;
    const TracedPhotons split = trace_photons(*ready->render, options);
    REQUIRE(split.arrivals.size() > plain.arrivals.size());
    std::uint64_t end = 0, covered = 0;
    for (const PathArrival& arrival : split.arrivals) {
        const std::uint64_t before = arrival.before.global, after = arrival.after.global;
        CHECK(before <= after);
        if (before < end) { // a further one of the same path
            CHECK(after <= end);
            continue;
        }
        covered += after - before;
        end = after;
    }
    CHECK(covered == split.global.size()); // indirect light has arrived somewhere before
}
