#include "render/lobes/multiple_scattering.h"
#include "tests/support/drawn_directions.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_scenes.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

Material compensated(Material material, float roughness)
{
    material.roughness = roughness;
    material.energy_compensation = true;
    return material;
}

/// Metal that is gathered and followed, below a clear coat and fibres, mixed with a coated base and
/// with glass, and anisotropic.
std::vector<Material> metals()
{
    const Material gold = tiny::mirror({1, 0.8f, 0.3f});
    Material lacquered = compensated(gold, 0.8f);
    lacquered.clearcoat = 0.9f;
    lacquered.clearcoat_roughness = 0.5f;
    Material velvet = compensated(gold, 0.6f);
    velvet.sheen_color = Rgb(0.7f);
    velvet.sheen_roughness = 0.4f;
    Material part = compensated(gold, 0.7f);
    part.metallic = 0.6f;
    part.specular = 1;
    Material with_glass = compensated(gold, 0.28f);
    with_glass.metallic = 0.6f;
    with_glass.transmission = 1;
    return {compensated(gold, 0.95f), compensated(gold, 0.3f), lacquered, velvet, part, with_glass};
}

/// The same by directions drawn, where no grid resolves a lobe.
RunningMean drawn_albedo(const Interaction& at, std::uint64_t draws)
{
    RunningMean out;
    for (std::uint64_t i = 0; i < draws; ++i) {
        RandomSequence random(5, RandomStream::pictures, 0, i);
        float sum = 0;
        if (at.gathers())
            sum += sample_scatter(at, Lobes::gathered, random).weight.x;
        if (at.follows())
            sum += sample_scatter(at, Lobes::followed, random).weight.x;
        out.add(sum);
    }
    return out;
}

bool is_compensated(const Interaction& at)
{
    const auto* lobe = std::get_if<MicrofacetReflection>(&at.bsdf().all[0].lobe);
    return lobe != nullptr && !is_black(lobe->multiple);
}

} // namespace

TEST_CASE("energy compensation: white metal sends on all light, at every roughness and angle",
          "[shading]")
{
    for (const float roughness : {0.05f, 0.25f, 0.35f, 0.5f, 0.75f, 1.0f})
        for (const glm::vec3& back : tiny::kBacks) {
            const Interaction at =
                tiny::lit_surface(compensated(tiny::mirror(Rgb(1)), roughness), back);
            const RunningMean mean = drawn_albedo(at, 20000);
            INFO("roughness " << roughness << ", height " << back.z << ": " << mean.mean());
            // The table of albedos is as near as that.
            CHECK(std::abs(mean.mean() - 1) < 0.003 + kMostZ * mean.standard_error());
            CHECK(mean.standard_error() < 0.004);
        }
}

TEST_CASE("energy compensation: multiple scattering is less where more is absorbed on the way",
          "[shading]")
{
    for (const float roughness : {0.4f, 1.0f}) {
        const Material gold = compensated(tiny::mirror({1, 0.5f, 0.1f}), roughness);
        Material plain = gold;
        plain.energy_compensation = false;
        const glm::dvec3 more = tiny::sent(tiny::lit_surface(gold, tiny::kBacks[1]), 200);
        const glm::dvec3 before = tiny::sent(tiny::lit_surface(plain, tiny::kBacks[1]), 200);
        const glm::dvec3 gain = more / before;
        CHECK(more.x == Approx(1).margin(0.004));
        CHECK(gain.x > gain.y);
        CHECK(gain.y > gain.z);
        CHECK(gain.z > 1);
    }
}

TEST_CASE("energy compensation: light between facets is the sum of all its reflections",
          "[shading]")
{
    // Facets reflect F of what they meet on average, and 1 - loss of what one reflects gets out.
    const float alpha = 0.6f, color = 0.4f, average = color + (1 - color) / 21;
    const Rgb white = multiple_factor(Rgb(1), alpha);
    double loss = 0;
    constexpr int kPoints = 20000;
    for (int i = 0; i < kPoints; ++i) // the square of the cosine is uniform
        loss += multiple_albedo(white, std::sqrt((i + 0.5f) / kPoints), alpha).x / kPoints;
    double series = 0, inside = average; // what is left inside after one reflection
    for (int i = 0; i < 100; ++i) {
        inside *= average;
        series += inside * (1 - loss);
        inside *= loss;
    }
    CHECK(multiple_factor(Rgb(color), alpha).x / white.x == Approx(series).epsilon(1e-3));
    CHECK(loss > 0.1);
}

TEST_CASE("energy compensation: directions are drawn with the pdf that is returned", "[shading]")
{
    for (const Material& material : metals())
        for (const Lobes lobes : {Lobes::gathered, Lobes::followed}) {
            const Interaction at = tiny::lit_surface(material, tiny::kBacks[2]);
            if (lobes == Lobes::gathered ? !at.gathers() : !at.follows())
                continue;
            INFO("roughness " << material.roughness << ", set " << int(lobes));
            CHECK(tiny::chi_square_z(at, lobes) < kMostZ);
        }
    const Interaction tilted = tiny::tilted_surface(metals()[0], {0.8f, 0, 0.6f});
    CHECK(tiny::chi_square_z(tilted, Lobes::gathered) < kMostZ);
}

TEST_CASE("energy compensation: the mean weight is the integral of the lobes, for photons too",
          "[shading]")
{
    for (const Material& material : metals())
        for (const Lobes lobes : {Lobes::gathered, Lobes::followed}) {
            const Interaction at = tiny::lit_surface(material, tiny::kBacks[1]);
            if (!reflects(at.bsdf(), lobes))
                continue;
            double integral = 0;
            tiny::over_sphere(250, [&](const glm::vec3& in, double solid_angle) {
                integral += double{scattered(at, in, lobes).value.y} * solid_angle;
            });
            RunningMean mean, of_particles;
            for (std::uint64_t i = 0; i < 20000; ++i) {
                RandomSequence random(5, RandomStream::pictures, 0, i);
                const ScatterSample sample = sample_scatter(at, lobes, random);
                mean.add(sample.weight.y / (sample.eta * sample.eta));
                of_particles.add(tiny::particle_weights(at, lobes, random).y);
            }
            INFO("roughness " << material.roughness << ", set " << int(lobes));
            CHECK(std::abs(mean.mean() - integral) < 0.002 + kMostZ * mean.standard_error());
            CHECK(std::abs(of_particles.mean() - integral) <
                  0.006 + kMostZ * of_particles.standard_error());
            CHECK(mean.standard_error() < 0.01);
        }
}

TEST_CASE("energy compensation: light takes the same way back", "[shading]")
{
    tiny::there_and_back(metals(), [](float there, float back) {
        CHECK(there == Approx(back).epsilon(2e-3).margin(1e-5));
    });
}

TEST_CASE("energy compensation: no surface sends on more than all", "[shading]")
{
    for (const float anisotropy : {0.0f, 1.0f})
        for (const float roughness : {0.0f, 0.5f, 0.9f})
            for (const glm::vec3& back : tiny::kBacks)
                for (const float metallic : {0.5f, 1.0f}) {
                    Material white = compensated(tiny::mirror(Rgb(1)), roughness);
                    white.metallic = metallic;
                    white.anisotropy = anisotropy;
                    Interaction at = tiny::lit_surface(white, back);
                    at.tangent = {0.8f, 0.6f, 0};
                    INFO("stretch " << anisotropy << ", roughness " << roughness << ", height "
                                    << back.z << ", metallic " << metallic);
                    const RunningMean mean = drawn_albedo(at, 5000); // of a mirror: none
                    CHECK(mean.mean() <= 1.003 + kMostZ * mean.standard_error());
                    CHECK(mean.standard_error() < 0.015);
                }
}

TEST_CASE("energy compensation: mirrors, plastic and glass have none, nor metal that is not asked",
          "[shading]")
{
    Material plastic = tiny::diffuse(Rgb(0.5f));
    plastic.specular = 1;
    Material plain = tiny::mirror(Rgb(1));
    plain.roughness = 1;
    for (const Material& material :
         {compensated(tiny::mirror(Rgb(1)), 0), compensated(plastic, 0.7f),
          compensated(tiny::glass(1.5f), 0.7f), plain})
        CHECK_FALSE(is_compensated(tiny::lit_surface(material, tiny::kBacks[0])));
    CHECK(is_compensated(tiny::lit_surface(compensated(plain, 1), tiny::kBacks[0])));
}
