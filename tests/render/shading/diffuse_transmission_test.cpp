#include "render/shading/photon_lobes.h"
#include "tests/render/shading/plastic.h"
#include "tests/support/drawn_directions.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_scenes.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

Material through(Material material, float share, const Rgb& colour)
{
    material.diffuse_transmission = share;
    material.diffuse_transmission_color = colour;
    return material;
}

/// Paper, under a coat, with fibres, and under a clear coat.
std::vector<Material> papers()
{
    Material cloth = tiny::diffuse(Rgb(0.6f));
    cloth.sheen_color = Rgb(0.8f);
    cloth.sheen_roughness = 0.4f;
    Material lacquered = tiny::plastic(0.5f);
    lacquered.clearcoat = 0.8f;
    lacquered.clearcoat_roughness = 0.5f;
    const Rgb green(0.3f, 0.9f, 0.2f);
    return {through(tiny::diffuse(Rgb(0.8f)), 0.4f, green),
            through(tiny::diffuse(Rgb(0.8f)), 1, green), through(tiny::plastic(0.5f), 0.7f, green),
            through(cloth, 0.5f, green), through(lacquered, 0.6f, green)};
}

const glm::vec3 kPaperBacks[] = {{0.1f, 0, 1}, {0.7f, -0.4f, 0.6f}, {-1, 0.2f, -0.3f}};

/// All that the lobes send on of light from at.back, to its side and to the other.
std::array<double, 2> sent_both_ways(const Interaction& at)
{
    std::array<double, 2> sums{};
    tiny::over_sphere(250, [&](const glm::vec3& in, double solid_angle) {
        for (const Lobes lobes : {Lobes::gathered, Lobes::followed})
            sums[glm::dot(in, at.normal) > 0 ? 0 : 1] +=
                double{scattered(at, in, lobes).value.x} * solid_angle;
    });
    return sums;
}

} // namespace

TEST_CASE("diffuse transmission: paper parts light by its share, each side in its colour",
          "[shading]")
{
    const Material paper = through(tiny::diffuse(Rgb(0.5f)), 0.25f, Rgb(0.8f));
    for (const glm::vec3& back : kPaperBacks) {
        const auto [reflected, passed] = sent_both_ways(tiny::lit_surface(paper, back, false));
        CHECK(reflected == Approx(0.75 * 0.5).epsilon(1e-3));
        CHECK(passed == Approx(0.25 * 0.8).epsilon(1e-3));
    }
}

TEST_CASE("diffuse transmission: white paper absorbs nothing, under coats neither", "[shading]")
{
    Material coated = tiny::diffuse(Rgb(1));
    coated.specular = 1;
    coated.roughness = 0.4f;
    Material lacquered = tiny::diffuse(Rgb(1));
    lacquered.clearcoat = 1;
    lacquered.clearcoat_roughness = 0.3f;
    for (const Material& base : {tiny::diffuse(Rgb(1)), coated, lacquered})
        for (const float share : {0.3f, 1.0f})
            for (const glm::vec3& back : kPaperBacks) {
                const auto [reflected, passed] =
                    sent_both_ways(tiny::lit_surface(through(base, share, Rgb(1)), back, false));
                CHECK(reflected + passed == Approx(1).margin(0.005));
            }
}

TEST_CASE("diffuse transmission: directions are drawn with the pdf that is returned", "[shading]")
{
    for (const Material& material : papers())
        for (const glm::vec3& back : kPaperBacks)
            CHECK(tiny::chi_square_z(tiny::lit_surface(material, back, false), Lobes::gathered) <
                  kMostZ);
    const Interaction bumpy = tiny::tilted_surface(papers()[2], {0.8f, 0, 0.6f});
    CHECK(tiny::chi_square_z(bumpy, Lobes::gathered) < kMostZ);
}

TEST_CASE("diffuse transmission: the mean weight is the integral of the lobes", "[shading]")
{
    for (const Material& material : papers()) {
        const Interaction at = tiny::lit_surface(material, kPaperBacks[1], false);
        double integral = 0;
        tiny::over_sphere(250, [&](const glm::vec3& in, double solid_angle) {
            integral += double{scattered(at, in, Lobes::gathered).value.y} * solid_angle;
        });
        RunningMean mean;
        for (std::uint64_t i = 0; i < 20000; ++i) {
            RandomSequence random(5, RandomStream::pictures, 0, i);
            const ScatterSample drawn = sample_scatter(at, Lobes::gathered, random);
            mean.add(drawn.weight.y);
            if (!is_black(drawn.weight))
                CHECK(drawn.transmitted == (glm::dot(drawn.direction, at.normal) < 0));
        }
        CHECK(std::abs(mean.mean() - integral) < 0.002 + kMostZ * mean.standard_error());
    }
}

TEST_CASE("diffuse transmission: light takes the same way back", "[shading]")
{
    const std::vector<Material> materials = papers();
    for (std::uint64_t i = 0; i < 4000; ++i) {
        RandomSequence random(11, RandomStream::pictures, 0, i);
        const Material& material = materials[i % materials.size()];
        const glm::vec3 a = sample_sphere(random.next2()), b = sample_sphere(random.next2());
        const Interaction from_a = tiny::lit_surface(material, a, false),
                          from_b = tiny::lit_surface(material, b, false);
        const float there = scattered(from_a, b, Lobes::gathered).value.y / std::abs(b.z);
        const float back = scattered(from_b, a, Lobes::gathered).value.y / std::abs(a.z);
        CHECK(there == Approx(back).epsilon(2e-3).margin(1e-5));
    }
}

TEST_CASE("diffuse transmission: photons are weighed by the lobes that rays are", "[shading]")
{
    for (const Material& material : papers()) {
        const Interaction at = tiny::lit_surface(material, kPaperBacks[1], false);
        const PhotonLobes lobes(at);
        for (std::uint64_t i = 0; i < 300; ++i) {
            RandomSequence random(13, RandomStream::pictures, 0, i);
            const glm::vec3 in = sample_sphere(random.next2());
            CHECK(lobes(in).y * std::abs(in.z) ==
                  Approx(scattered(at, in, Lobes::gathered).value.y).epsilon(1e-3).margin(1e-6));
            if (in.z < 0)
                CHECK(
                    (lobes.behind() * transmitted_by(at.bsdf().layers, Depth::diffuse, -in.z)).y ==
                    Approx(lobes(in).y).epsilon(1e-4));
        }
    }
}

TEST_CASE("diffuse transmission: that of glass is none, nor is none", "[shading]")
{
    for (const Material& material :
         {through(tiny::glass(1.5f), 1, Rgb(1)), through(tiny::diffuse(Rgb(0.5f)), 0, Rgb(1)),
          through(tiny::diffuse(Rgb(0.5f)), 1, Rgb(0))})
        CHECK_FALSE(tiny::lit_surface(material, {0, 0, 1}).bsdf().transmits_diffusely);
    CHECK(tiny::lit_surface(through(tiny::diffuse(Rgb(0)), 1, Rgb(1)), {0, 0, 1}).gathers());
}
