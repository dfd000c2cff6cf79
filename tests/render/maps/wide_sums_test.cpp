#include "render/maps/wide_batch.h"
#include "tests/render/maps/point_sets.h"
#include "tests/support/instruction_sets.h"

#include <catch2/catch.hpp>

using namespace hipmap;
using namespace hipmap::point_sets;

namespace {

struct TestTree {
    WideTree tree;
    PhotonPowers powers;
    std::vector<std::uint32_t> order; ///< photons' numbers by slot

    explicit TestTree(const Points& positions)
    {
        std::vector<Photon> photons;
        std::vector<TreePoint> points;
        for (std::size_t i = 0; i < positions.size(); ++i) {
            RandomSequence random(9, RandomStream::photons, 0, i);
            photons.push_back(
                {positions[i], Rgb(random.next(), 1, random.next()), {0, 0, 1}, 0, 0});
            points.push_back({positions[i], static_cast<std::uint32_t>(i)});
        }
        tree = build_wide_tree(points);
        powers = build_powers(tree, points, photons, power_scale(photons));
        for (const TreePoint& point : points)
            order.push_back(point.photon);
    }
};

/// As NearestSum says, from the list.
NearestSum sum_of_list(const TestTree& of, const TreeQuery& query)
{
    TreeScratch scratch;
    const FoundSlots found = find_nearest(of.tree, query, scratch);
    NearestSum sum{PowerSum(0), found.slots.size(), found.farthest2};
    const std::size_t counted =
        found.slots.size() == query.photons ? query.photons - 1 : found.slots.size();
    for (const std::uint32_t slot : found.slots.first(counted))
        sum.power += of.powers.of(slot);
    return sum;
}

template <std::size_t n>
RadiusSums<n> sum_by_hand(const TestTree& of, const glm::vec3& point,
                          const std::array<float, n>& radii2)
{
    RadiusSums<n> sums;
    for (std::uint32_t slot = 0; slot < of.tree.size; ++slot) {
        const glm::vec3 d = of.tree.position(slot) - point;
        for (std::size_t r = 0; r < n; ++r)
            if (glm::dot(d, d) <= radii2[r]) {
                sums[r].power += of.powers.of(slot);
                ++sums[r].photons;
            }
    }
    return sums;
}

template <std::size_t n>
bool same(const RadiusSums<n>& a, const RadiusSums<n>& b)
{
    return std::equal(a.begin(), a.end(), b.begin(), [](const RadiusSum& x, const RadiusSum& y) {
        return x.power == y.power && x.photons == y.photons;
    });
}

/// Points near each other and far apart, as an image asks for them.
Points make_walk(const Points& points, std::uint64_t seed)
{
    Points walk;
    glm::vec3 at(0.5f);
    for (std::uint64_t i = 0; i < 24; ++i) {
        RandomSequence random(seed, RandomStream::eye_paths, 0, i);
        if (i % 6 == 0 && !points.empty())
            at = points[static_cast<std::size_t>(random.next() * float(points.size()))];
        at += 0.01f * (anywhere(random) - 0.5f);
        walk.push_back(at);
    }
    return walk;
}

/// Number of sums compared; all must be equal to the bit.
int compare(const Points& points, std::uint64_t seed)
{
    const TestTree of(points);
    TreeScratch near[5], within;
    int compared = 0;
    for (const glm::vec3& at : make_walk(points, seed)) {
        const std::size_t wanted[] = {1, 2, 50, 600, 30000};
        for (std::size_t i = 0; i < 5; ++i) {
            TreeQuery query{at, wanted[i]};
            if (seed % 3 == 0)
                query.radius2 = 0.04f;
            if (seed % 2 == 0)
                query.order = of.order.data();
            const NearestSum found = sum_nearest(of.tree, of.powers, query, near[i]);
            const NearestSum truth = sum_of_list(of, query);
            CHECK(found.power == truth.power);
            CHECK(found.photons == truth.photons);
            CHECK(found.farthest2 == truth.farthest2);
        }
        for (const float radius : {0.0f, 0.01f, 0.1f, 0.5f, 4.0f}) {
            const std::array<float, 3> radii2{radius * radius, 0.8f * radius * radius,
                                              0.1f * radius * radius};
            CHECK(same(sum_within(of.tree, of.powers, at, radii2, within),
                       sum_by_hand(of, at, radii2)));
            const std::array<float, 1> one{radius * radius};
            CHECK(same(sum_within(of.tree, of.powers, at, one, within), sum_by_hand(of, at, one)));
        }
        compared += 15;
    }
    return compared;
}

} // namespace

TEST_CASE("wide sums: every kernel adds what a list holds, to the bit", "[maps]")
{
    with_each_instruction_set([&] {
        int compared = 0;
        std::uint64_t seed = 0;
        for (const auto& [name, place] : kPlaces)
            for (const std::size_t count : {0, 1, 16, 17, 50, 255, 257, 601, 5000}) {
                INFO(name << ", " << count << " photons");
                compared += compare(make_points(place, count, count), ++seed);
            }
        CHECK(compared > 1000);
    });
}

TEST_CASE("wide sums: a batch has the sums of searches one by one, to the bit", "[maps]")
{
    with_each_instruction_set([&] {
        for (const auto& [name, place] : kPlaces)
            for (const std::size_t count : {0, 1, 16, 257, 5000}) {
                INFO(name << ", " << count << " photons");
                const TestTree of(make_points(place, count, count));
                BatchScratch scratch;
                for (const std::size_t asked : {0, 1, 7, 100, 3000}) {
                    Points points = make_points(place, count + 1, asked);
                    if (asked == 7)
                        points[3].y = std::numeric_limits<float>::quiet_NaN();
                    for (const float radius : {0.0f, 0.05f, 0.3f, 4.0f}) {
                        std::vector<RadiusSum> sums(asked, RadiusSum{PowerSum(1), 1});
                        sum_within({of.tree, of.powers}, points, radius * radius, sums, scratch);
                        std::size_t different = 0;
                        for (std::size_t i = 0; i < asked; ++i) {
                            const auto alone =
                                sum_within(of.tree, of.powers, points[i],
                                           std::array<float, 1>{radius * radius}, scratch.single);
                            different += same<1>({sums[i]}, alone) ? 0 : 1;
                        }
                        CHECK(different == 0);
                    }
                }
            }
    });
}

TEST_CASE("wide sums: a place that is not a number has none", "[maps]")
{
    const TestTree of(make_points(anywhere, 3, 1000));
    TreeScratch scratch;
    const glm::vec3 nowhere(std::numeric_limits<float>::quiet_NaN());
    CHECK(sum_nearest(of.tree, of.powers, {nowhere, 10}, scratch).photons == 0);
    const RadiusSums<3> sums =
        sum_within(of.tree, of.powers, nowhere, std::array<float, 3>{1, 1, 1}, scratch);
    CHECK(sums[0].photons == 0);
}
