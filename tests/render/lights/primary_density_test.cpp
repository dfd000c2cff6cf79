#include "render/lights/primary_density.h"
#include "tests/support/statistics.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

PrimarySample even_sample(std::uint64_t i)
{
    RandomSequence random(3, RandomStream::photons, 0, 7, i);
    PrimarySample out;
    for (glm::vec2& step : out)
        step = random.next2();
    return out;
}

/// Worth within a box about the middle of two dimensions of different steps, and nothing elsewhere.
double worth_at(const PrimarySample& at)
{
    return std::abs(at[0].y - 0.5f) < 0.05f && std::abs(at[2].x - 0.5f) < 0.05f ? 1.0 : 0.0;
}

/// What `rounds` of points, each by the density learnt of the last, say.
PrimaryDensity learn(int rounds, std::uint64_t points)
{
    PrimaryDensity out;
    for (int round = 0; round < rounds; ++round) {
        std::vector<PrimaryWorth> found;
        for (std::uint64_t i = 0; i < points; ++i) {
            const DrawnPrimary drawn = draw(out, even_sample(i + points * round));
            found.push_back({drawn.at, worth_at(drawn.at), drawn.density});
        }
        out = mixed_with_even(learn_density(found, 64), 0.25);
    }
    return out;
}

} // namespace

TEST_CASE("primary density: without worth it is even", "[lights]")
{
    std::vector<PrimaryWorth> nothing(1000);
    for (std::size_t i = 0; i < nothing.size(); ++i)
        nothing[i].at = even_sample(i);
    const LearntDensity learnt = learn_density(nothing, 64);
    CHECK(learnt.worth == 0);
    CHECK(learn_density({}, 64).density.nodes.empty());
    const DrawnPrimary drawn = draw(learnt.density, even_sample(5));
    CHECK(drawn.at == even_sample(5));
    CHECK(drawn.density == 1);
}

TEST_CASE("primary density: even worth is left even", "[lights]")
{
    std::vector<PrimaryWorth> even(20000);
    for (std::size_t i = 0; i < even.size(); ++i)
        even[i] = {even_sample(i), 1.0, 1.0};
    CHECK(learn_density(even, 64).density.nodes.size() == 1);
}

TEST_CASE("primary density: draws where worth is, by the density that it says", "[lights]")
{
    const PrimaryDensity density = learn(2, 40000);
    RunningMean share, worth, volume;
    for (std::uint64_t i = 0; i < 40000; ++i) {
        const DrawnPrimary drawn = draw(density, even_sample(i));
        share.add(worth_at(drawn.at));
        worth.add(worth_at(drawn.at) / drawn.density);
        volume.add(1 / drawn.density);
        REQUIRE(drawn.density == Approx(density_at(density, drawn.at)).epsilon(1e-4));
        REQUIRE(drawn.density > 0.24);
    }
    CHECK(share.mean() > 0.5); // by even points 0.01
    CHECK(std::abs(worth.z_score(0.01)) < kMostZ);
    CHECK(std::abs(volume.z_score(1)) < kMostZ);
}

TEST_CASE("primary density: worth in a speck makes no cell too dense for stored powers", "[lights]")
{
    std::vector<PrimaryWorth> points(4000);
    for (std::size_t i = 0; i < points.size(); ++i) {
        points[i] = {even_sample(i), 1, 1};
        for (glm::vec2& step : points[i].at)
            step = 0.3f + 0.001f * step;
    }
    const PrimaryDensity density = mixed_with_even(learn_density(points, 64), 0.25);
    const double there = density_at(density, points[0].at);
    CHECK(there > 100);
    CHECK(there < 512);
}
