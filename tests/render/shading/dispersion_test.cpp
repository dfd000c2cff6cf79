#include "render/shading/dispersion.h"
#include "tests/support/lit_surface.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_scenes.h"

#include <catch2/catch.hpp>

#include <array>

using namespace hipmap;

namespace {

constexpr float kLineF = 486.1f, kLineD = 587.6f, kLineC = 656.3f; ///< nanometres

Material flint(float roughness = 0)
{
    Material material = tiny::glass(1.6f);
    material.dispersion = 1;
    material.roughness = roughness;
    return material;
}

} // namespace

TEST_CASE("dispersion: white light stays white, and no wavelength weighs more than three of it",
          "[shading]")
{
    constexpr int kDraws = 1 << 16; // the midpoints of so many parts: all but exact
    glm::dvec3 mean(0.0);
    for (int i = 0; i < kDraws; ++i) {
        const WavelengthSample drawn = sample_wavelength((static_cast<float>(i) + 0.5f) / kDraws);
        CHECK((drawn.nanometres >= 380 && drawn.nanometres <= 720));
        CHECK(std::min({drawn.weight.x, drawn.weight.y, drawn.weight.z}) >= 0);
        CHECK(drawn.weight.x + drawn.weight.y + drawn.weight.z == Approx(3));
        mean += glm::dvec3(drawn.weight) / double{kDraws};
    }
    for (int c = 0; c < 3; ++c)
        CHECK(mean[c] == Approx(1).margin(1e-3));
}

TEST_CASE("dispersion: wavelengths are drawn as often as their colour says", "[shading]")
{
    // Red light is drawn with the mean response over the red one: counts by bin follow from
    // weights.
    constexpr int kBins = 17, kDraws = 40000;
    std::array<double, kBins> expected{}, drawn{};
    for (int i = 0; i < 64 * kDraws; ++i)
        expected[static_cast<std::size_t>(
            (sample_wavelength((static_cast<float>(i) + 0.5f) / (64 * kDraws)).nanometres - 380) /
            20.0f)] += 1.0 / 64;
    for (std::uint64_t i = 0; i < kDraws; ++i) {
        RandomSequence random(9, RandomStream::pictures, 0, i);
        ++drawn[static_cast<std::size_t>((sample_wavelength(random.next()).nanometres - 380) /
                                         20.0f)];
    }
    double square = 0, bins = 0;
    for (std::size_t i = 0; i < kBins; ++i)
        if (expected[i] > 20) {
            square += (drawn[i] - expected[i]) * (drawn[i] - expected[i]) / expected[i];
            ++bins;
        }
    CHECK(bins > 8);
    CHECK((square - (bins - 1)) / std::sqrt(2 * (bins - 1)) < kMostZ);
}

TEST_CASE("dispersion: the index has the Abbe number asked for", "[shading]")
{
    for (const float ior : {1.3f, 1.5f, 2.4f})
        for (const float dispersion : {0.2f, 0.5f, 1.0f}) {
            CHECK(dispersed_index(ior, dispersion, kLineD) == Approx(ior).margin(2e-4));
            const float spread =
                dispersed_index(ior, dispersion, kLineF) - dispersed_index(ior, dispersion, kLineC);
            CHECK((ior - 1) / spread == Approx(20 / dispersion).epsilon(2e-3));
        }
    CHECK(dispersed_index(1.01f, 1000, 720) == 1);
    CHECK(dispersed_index(1.5f, 0, 400) == 1.5f);
}

TEST_CASE("dispersion: a path keeps the wavelength that it has drawn, and weighs it once",
          "[shading]")
{
    RunningMean red;
    for (std::uint64_t i = 0; i < 4000; ++i) {
        RandomSequence random(4, RandomStream::pictures, 0, i);
        float nanometres = 0;
        Rgb carried(2.0f);
        Interaction at = tiny::lit_surface(flint(), {0, 0, 1});
        disperse(at, nanometres, carried, random);
        const float drawn = nanometres, index = at.ior;
        const Rgb weight = carried;
        CHECK(index == dispersed_index(1.6f, 1, drawn));
        Interaction again = tiny::lit_surface(flint(0.3f), {0, 0, -1});
        disperse(again, nanometres, carried, random);
        CHECK(nanometres == drawn);
        CHECK(carried == weight);
        CHECK(again.ior == index);
        red.add(carried.x);
    }
    CHECK(std::abs(red.z_score(2)) < kMostZ);
}

TEST_CASE("dispersion: thin panes, and glass without it, leave a path as it is", "[shading]")
{
    Interaction pane = tiny::lit_surface(flint(), {0, 0, 1}, false);
    Interaction clear = tiny::lit_surface(tiny::glass(1.6f), {0, 0, 1});
    for (Interaction* at : {&pane, &clear}) {
        RandomSequence random(4, RandomStream::pictures, 0, 0);
        float nanometres = 0;
        Rgb carried(1.0f);
        disperse(*at, nanometres, carried, random);
        CHECK(nanometres == 0);
        CHECK(carried == Rgb(1));
        CHECK(at->ior == 1.6f);
    }
}
