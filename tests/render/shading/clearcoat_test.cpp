#include "tests/support/drawn_directions.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_scenes.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

/// Coats that are mirrors, followed and gathered, over bases that are diffuse, and that reflect in
/// each way.
std::vector<Material> lacquers()
{
    Material plastic = tiny::diffuse({0.8f, 0.5f, 0.2f});
    plastic.specular = 1;
    const Material gold = tiny::mirror({1, 0.8f, 0.3f}),
                   diffuse = tiny::diffuse({0.8f, 0.5f, 0.2f});
    return {tiny::lacquered(diffuse, 1, 0),       tiny::lacquered(plastic, 0, 0),
            tiny::lacquered(gold, 0.25f, 0),      tiny::lacquered(diffuse, 1, 0.2f),
            tiny::lacquered(plastic, 0.6f, 0.2f), tiny::lacquered(gold, 0.25f, 0.2f),
            tiny::lacquered(gold, 0, 0.5f),       tiny::lacquered(plastic, 0.25f, 0.5f),
            tiny::lacquered(plastic, 0.6f, 0.5f), tiny::lacquered(gold, 0.6f, 0.5f)};
}

bool has(const Interaction& at, Lobes lobes)
{
    return lobes == Lobes::gathered ? at.gathers() : at.follows();
}

/// All that the surface sends on of light from at.back.
double sent_by_coat(const Interaction& at, int rows)
{
    double sum = specular_lobes(at).mirror.x;
    tiny::over_sphere(rows, [&](const glm::vec3& in, double solid_angle) {
        sum += (scattered(at, in, Lobes::gathered).value.x +
                scattered(at, in, Lobes::followed).value.x) *
               solid_angle;
    });
    return sum;
}

} // namespace

TEST_CASE("clear coat: directions are drawn with the pdf that is returned", "[shading]")
{
    for (const Material& material : lacquers())
        for (const Lobes lobes : {Lobes::gathered, Lobes::followed}) {
            const Interaction at = tiny::lit_surface(material, tiny::kBacks[2]);
            if (!has(at, lobes))
                continue;
            INFO("base " << material.roughness << ", metallic " << material.metallic << ", coat "
                         << material.clearcoat_roughness);
            CHECK(tiny::chi_square_z(at, lobes) < kMostZ);
        }
}

TEST_CASE("clear coat: the mean weight is the integral of the lobes, for photons too", "[shading]")
{
    for (const Material& material : lacquers())
        for (const Lobes lobes : {Lobes::gathered, Lobes::followed}) {
            const Interaction at = tiny::lit_surface(material, tiny::kBacks[1]);
            double integral = 0;
            tiny::over_sphere(250, [&](const glm::vec3& in, double solid_angle) {
                integral += double{scattered(at, in, lobes).value.y} * solid_angle;
            });
            if (!has(at, lobes)) {
                CHECK(integral == 0);
                continue;
            }
            RunningMean mean, of_particles;
            for (std::uint64_t i = 0; i < 20000; ++i) {
                RandomSequence random(5, RandomStream::pictures, 0, i);
                mean.add(sample_scatter(at, lobes, random).weight.y);
                of_particles.add(tiny::particle_weights(at, lobes, random).y);
            }
            INFO("base " << material.roughness << ", metallic " << material.metallic << ", coat "
                         << material.clearcoat_roughness << ", set " << int(lobes));
            CHECK(std::abs(mean.mean() - integral) < 0.002 + kMostZ * mean.standard_error());
            CHECK(std::abs(of_particles.mean() - integral) <
                  0.004 + kMostZ * of_particles.standard_error());
        }
}

TEST_CASE("clear coat: light takes the same way back", "[shading]")
{
    tiny::there_and_back(lacquers(), [](float there, float back) {
        CHECK(there == Approx(back).epsilon(2e-3).margin(1e-5));
    });
}

TEST_CASE("clear coat: no surface sends on more than all, a white base beneath absorbs nothing",
          "[shading]")
{
    Material coated = tiny::diffuse(Rgb(1));
    coated.specular = 1;
    for (const float coat : {0.0f, 0.25f, 0.6f})
        for (const glm::vec3& back : tiny::kBacks) {
            INFO("coat " << coat << ", height " << back.z);
            const Material diffuse = tiny::lacquered(tiny::diffuse(Rgb(1)), 1, coat);
            CHECK(sent_by_coat(tiny::lit_surface(diffuse, back), 160) == Approx(1).margin(0.004));
            const Interaction both = tiny::lit_surface(tiny::lacquered(coated, 0.4f, coat), back);
            CHECK(sent_by_coat(both, 160) <= 1.005);
            CHECK(sent_by_coat(both, 160) > 0.97);
            const Material metal = tiny::lacquered(tiny::mirror(Rgb(1)), 0.4f, coat);
            CHECK(sent_by_coat(tiny::lit_surface(metal, back), 160) <= 1.005);
        }
}

TEST_CASE("clear coat: factor 0, and a coat of glass, are none", "[shading]")
{
    Material material = tiny::lacquered(tiny::diffuse(Rgb(0.5f)), 1, 0);
    material.clearcoat = 0;
    CHECK(make_bsdf(material, material_factors(material)).layers.clearcoat == 0);
    material = tiny::lacquered(tiny::glass(1.5f), 0, 0);
    CHECK(make_bsdf(material, material_factors(material)).layers.clearcoat == 0);
}
