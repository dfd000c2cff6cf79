#include "common/math/random.h"
#include "common/math/sampling.h"
#include "render/lights/light_tree.h"
#include "tests/support/statistics.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace hipmap;

namespace {

/// Points (facing everywhere) and small one- and two-sided panels, spread over a hall of
/// 1 x 0.1 x 0.3.
std::vector<LightBounds> many_lights(std::size_t count, RandomSequence& random)
{
    std::vector<LightBounds> out(count);
    for (std::size_t i = 0; i < count; ++i) {
        const glm::vec2 u = random.next2();
        const glm::vec3 middle(u.x, 0.1f * random.next(), 0.3f * u.y);
        out[i].box.add(middle);
        out[i].power = 0.1 + random.next();
        out[i].axis = sample_sphere(random.next2());
        if (i % 3 == 0)
            out[i].cos_spread = -1;
        else
            out[i].box.add(middle + 0.01f * sample_sphere(random.next2()));
        out[i].both_sides = i % 3 == 1;
    }
    return out;
}

LightReceiver random_receiver(RandomSequence& random)
{
    LightReceiver at;
    at.position = {random.next(), 0.2f * random.next() - 0.05f, 0.3f * random.next()};
    if (random.next() < 0.7f)
        at.normal = sample_sphere(random.next2());
    return at;
}

double sum_of_probabilities(const LightTree& tree, const LightReceiver& at, std::size_t lights)
{
    double sum = 0;
    for (std::uint32_t i = 0; i < lights; ++i)
        sum += probability_of(tree, at, i);
    return sum;
}

/// The share of an even row of numbers that chooses some light.
double share_chosen(const LightTree& tree, const LightReceiver& at, int numbers)
{
    int chosen = 0;
    for (int i = 0; i < numbers; ++i)
        chosen += choose_light(tree, at, (i + 0.5) / numbers) ? 1 : 0;
    return static_cast<double>(chosen) / numbers;
}

} // namespace

TEST_CASE("light tree: probabilities of lights that emit everywhere add up to one", "[lights]")
{
    RandomSequence random(3, RandomStream::pictures, 0, 0);
    std::vector<LightBounds> lights = many_lights(300, random);
    for (LightBounds& light : lights)
        light.cos_spread = -1;
    const LightTree tree = build_light_tree(lights);
    for (int i = 0; i < 100; ++i) {
        LightReceiver at = random_receiver(random);
        at.normal = glm::vec3(0);
        CHECK(sum_of_probabilities(tree, at, lights.size()) == Approx(1).epsilon(1e-9));
    }
}

TEST_CASE("light tree: probabilities of all lights are what numbers choose a light", "[lights]")
{
    RandomSequence random(4, RandomStream::pictures, 0, 0);
    for (const std::size_t count : {1u, 2u, 7u, 200u}) {
        const std::vector<LightBounds> lights = many_lights(count, random);
        const LightTree tree = build_light_tree(lights);
        constexpr int kNumbers = 4000;
        for (int i = 0; i < 20; ++i) {
            const LightReceiver at = random_receiver(random);
            const double sum = sum_of_probabilities(tree, at, count);
            // Each light has an interval, of which rounding to the row moves two ends.
            CHECK(std::abs(share_chosen(tree, at, kNumbers) - sum) <
                  2.0 * static_cast<double>(count) / kNumbers);
            CHECK(sum < 1 + 1e-9);
        }
    }
}

TEST_CASE("light tree: each light is chosen as often as its probability says", "[lights]")
{
    RandomSequence random(5, RandomStream::pictures, 0, 0);
    const std::vector<LightBounds> lights = many_lights(40, random);
    const LightTree tree = build_light_tree(lights);
    const LightReceiver at{{0.4f, -0.05f, 0.1f}, {0, 1, 0}};
    constexpr int kDraws = 200'000;
    std::vector<double> found(lights.size(), 0.0);
    for (int i = 0; i < kDraws; ++i) {
        const std::optional<ChosenLight> chosen = choose_light(tree, at, random.next());
        if (!chosen)
            continue;
        found[chosen->light] += 1;
        CHECK(chosen->probability == Approx(probability_of(tree, at, chosen->light)).epsilon(1e-9));
    }
    for (std::uint32_t i = 0; i < lights.size(); ++i) {
        const double expected = kDraws * probability_of(tree, at, i);
        CHECK(std::abs(found[i] - expected) <= kMostZ * std::sqrt(expected) + 1);
    }
}

TEST_CASE("light tree: no light that reaches a receiver is left without a probability", "[lights]")
{
    RandomSequence random(6, RandomStream::pictures, 0, 0);
    const std::vector<LightBounds> lights = many_lights(200, random);
    const LightTree tree = build_light_tree(lights);
    int reaching = 0;
    for (int i = 0; i < 200; ++i) {
        const LightReceiver at = random_receiver(random);
        for (std::uint32_t l = 0; l < lights.size(); ++l) {
            // A corner of the panel, of which the other side is as good as any.
            const glm::vec3 way = lights[l].box.low - at.position;
            const float leaving = -glm::dot(way, lights[l].axis);
            const bool emits =
                lights[l].cos_spread < 0 || (lights[l].both_sides ? leaving != 0 : leaving > 0);
            const bool above = at.normal == glm::vec3(0) || glm::dot(way, at.normal) > 0;
            if (!emits || !above)
                continue;
            ++reaching;
            CHECK(probability_of(tree, at, l) > 0);
        }
    }
    CHECK(reaching > 5000);
}

TEST_CASE("light tree: lights in one place, and a receiver in it, do no harm", "[lights]")
{
    std::vector<LightBounds> lights(5);
    for (LightBounds& light : lights) {
        light.box.add({1, 2, 3});
        light.cos_spread = -1;
        light.power = 2;
    }
    const LightTree tree = build_light_tree(lights);
    CHECK_FALSE(choose_light(tree, {{1, 2, 3}, {0, 1, 0}}, 0.5));
    CHECK(probability_of(tree, {{1, 2, 3}, {}}, 3) == 0);
    CHECK(sum_of_probabilities(tree, {{1, 1, 3}, {0, 1, 0}}, 5) == Approx(1));
    CHECK(build_light_tree({}).empty());
    // As near as floats can be: nothing overflows.
    const glm::vec3 near(1, std::nextafter(2.0f, 0.0f), 3);
    CHECK(sum_of_probabilities(tree, {near, {}}, 5) == Approx(1));
}

TEST_CASE("light tree: one sample by it is far steadier than one by power", "[lights]")
{
    // Irradiance at points of the floor of a long hall below lights of equal power: the relative
    // variance of one light's contribution over its probability, summed exactly.
    std::vector<LightBounds> lights;
    for (int i = 0; i < 200; ++i) {
        LightBounds light;
        light.box.add({0.05f * static_cast<float>(i), 0.3f, 0.1f * static_cast<float>(i % 4)});
        light.cos_spread = -1;
        light.power = 1;
        lights.push_back(light);
    }
    const LightTree tree = build_light_tree(lights);
    double by_tree = 0, by_power = 0;
    for (int i = 0; i < 50; ++i) {
        const LightReceiver at{{0.2f * static_cast<float>(i), 0, 0.15f}, {0, 1, 0}};
        double sum = 0, tree_square = 0, power_square = 0;
        for (std::uint32_t l = 0; l < lights.size(); ++l) {
            const glm::dvec3 way = lights[l].box.low - at.position;
            const double light = way.y / std::pow(glm::dot(way, way), 1.5);
            sum += light;
            tree_square += light * light / probability_of(tree, at, l);
            power_square += light * light * static_cast<double>(lights.size());
        }
        by_tree += tree_square / (sum * sum) - 1;
        by_power += power_square / (sum * sum) - 1;
    }
    CHECK(by_tree < 0.1 * by_power);
}
