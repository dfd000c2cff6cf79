#include "render/lobes/sheen_albedo.h"
#include "render/shading/photon_lobes.h"
#include "tests/support/drawn_directions.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_scenes.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

Material velvet(Material material, const Rgb& colour, float roughness)
{
    material.sheen_color = colour;
    material.sheen_roughness = roughness;
    return material;
}

/// Over a diffuse base, one with a coat, metal that is gathered and followed, and below a clear
/// coat.
std::vector<Material> velvets()
{
    Material plastic = tiny::diffuse({0.8f, 0.5f, 0.2f});
    plastic.specular = 1;
    plastic.roughness = 0.5f;
    Material gold = tiny::mirror({1, 0.8f, 0.3f});
    gold.roughness = 0.5f;
    Material steel = tiny::mirror(Rgb(0.8f));
    steel.roughness = 0.2f;
    Material lacquered = plastic;
    lacquered.clearcoat = 0.8f;
    lacquered.clearcoat_roughness = 0.5f;
    return {velvet(tiny::diffuse({0.8f, 0.5f, 0.2f}), {1, 0.6f, 0.3f}, 0.1f),
            velvet(plastic, {0.9f, 0.9f, 1}, 0.4f), velvet(gold, Rgb(1), 0.8f),
            velvet(steel, {0.5f, 0.7f, 1}, 0.3f), velvet(lacquered, Rgb(0.9f), 0.6f)};
}

/// The lobe as the extension writes it.
double lobe_by_the_text(double cos_in, double cos_out, double cos_half, double alpha)
{
    const auto lambda = [alpha](double cosine) {
        const double t = (1 - alpha) * (1 - alpha);
        const auto l = [&](double x) {
            const double a = 21.5473 * (1 - t) + 25.3245 * t, b = 3.82987 * (1 - t) + 3.32435 * t;
            const double c = 0.19823 * (1 - t) + 0.16801 * t, d = -1.97760 * (1 - t) - 1.27393 * t;
            return a / (1 + b * std::pow(x, c)) + d * x + (-4.32054 * (1 - t) - 4.85967 * t);
        };
        return cosine < 0.5 ? std::exp(l(cosine)) : std::exp(2 * l(0.5) - l(1 - cosine));
    };
    const double spread =
        (2 + 1 / alpha) * std::pow(1 - cos_half * cos_half, 0.5 / alpha) / (2 * std::numbers::pi);
    return spread / ((1 + lambda(cos_in) + lambda(cos_out)) * 4 * cos_in * cos_out);
}

} // namespace

TEST_CASE("sheen: the lobe is the extension's", "[shading]")
{
    for (std::uint64_t i = 0; i < 2000; ++i) {
        RandomSequence random(7, RandomStream::pictures, 0, i);
        const float alpha = kLeastSheenAlpha + (1 - kLeastSheenAlpha) * random.next();
        const glm::vec3 in = direction_from_cosine(0.01f + 0.99f * random.next(), random.next());
        const glm::vec3 out = direction_from_cosine(0.01f + 0.99f * random.next(), random.next());
        const double cos_half = glm::normalize(glm::dvec3(in) + glm::dvec3(out)).z;
        const auto sin2_half = static_cast<float>(1 - cos_half * cos_half);
        CHECK(sheen_lobe(in.z, out.z, sin2_half, alpha) ==
              Approx(lobe_by_the_text(in.z, out.z, cos_half, alpha)).epsilon(1e-4).margin(1e-9));
    }
}

TEST_CASE("sheen: the table is the integral of the lobe, below one", "[shading]")
{
    for (const float alpha : {kLeastSheenAlpha, 0.13f, 0.37f, 1.0f})
        for (const float cosine : {0.003f, 0.013f, 0.11f, 0.35f, 0.8f}) {
            double sum = 0;
            constexpr int kPoints = 300;
            for (int i = 0; i < kPoints; ++i)
                for (int j = 0; j < kPoints; ++j) {
                    const double x = (i + 0.5) / kPoints, in = x * x;
                    const double turn = (j + 0.5) / kPoints * std::numbers::pi;
                    const double sines = std::sqrt((1 - in * in) * (1 - double{cosine} * cosine));
                    const double dot = in * cosine + sines * std::cos(turn);
                    const double half2 = (in + cosine) * (in + cosine) / (2 + 2 * dot);
                    sum += in * 2 * x *
                           sheen_lobe(static_cast<float>(in), cosine, static_cast<float>(1 - half2),
                                      alpha);
                }
            sum *= 2 * std::numbers::pi / (kPoints * kPoints);
            INFO("alpha " << alpha << ", cosine " << cosine);
            CHECK(std::abs(sheen_albedo(cosine, alpha) - sum) < 0.004);
            CHECK(sheen_albedo(cosine, alpha) < 1);
        }
    for (const float cosine : {0.0f, 1e-9f, 1e-5f})
        CHECK(sheen_albedo(cosine, kLeastSheenAlpha) < 1);
}

TEST_CASE("sheen: directions are drawn with the pdf that is returned", "[shading]")
{
    for (const Material& material : velvets())
        for (const glm::vec3& back : {tiny::kBacks[0], tiny::kBacks[2]})
            CHECK(tiny::chi_square_z(tiny::lit_surface(material, back), Lobes::gathered) < kMostZ);
}

TEST_CASE("sheen: the mean weight is the integral of the lobes, for photons too", "[shading]")
{
    for (const Material& material : velvets()) {
        const Interaction at = tiny::lit_surface(material, tiny::kBacks[1]);
        double integral = 0;
        tiny::over_sphere(250, [&](const glm::vec3& in, double solid_angle) {
            integral += double{scattered(at, in, Lobes::gathered).value.y} * solid_angle;
        });
        RunningMean mean, of_particles;
        for (std::uint64_t i = 0; i < 20000; ++i) {
            RandomSequence random(5, RandomStream::pictures, 0, i);
            mean.add(sample_scatter(at, Lobes::gathered, random).weight.y);
            of_particles.add(tiny::particle_weights(at, Lobes::gathered, random).y);
        }
        INFO("sheen " << material.sheen_roughness);
        CHECK(std::abs(mean.mean() - integral) < 0.002 + kMostZ * mean.standard_error());
        CHECK(std::abs(of_particles.mean() - integral) <
              0.002 + kMostZ * of_particles.standard_error());
    }
}

TEST_CASE("sheen: light takes the same way back", "[shading]")
{
    const std::vector<Material> materials = velvets();
    for (std::uint64_t i = 0; i < 4000; ++i) {
        RandomSequence random(11, RandomStream::pictures, 0, i);
        const Material& material = materials[i % materials.size()];
        glm::vec3 a = sample_sphere(random.next2()), b = sample_sphere(random.next2());
        a.z = std::abs(a.z);
        b.z = std::abs(b.z);
        const Interaction from_a = tiny::lit_surface(material, a),
                          from_b = tiny::lit_surface(material, b);
        const float there = scattered(from_a, b, Lobes::gathered).value.x / b.z;
        const float back = scattered(from_b, a, Lobes::gathered).value.x / a.z;
        CHECK(there == Approx(back).epsilon(2e-3).margin(1e-5));
    }
}

TEST_CASE("sheen: no surface sends on more than all, a white base beneath absorbs nothing",
          "[shading]")
{
    for (const float roughness : {0.0f, 0.2f, 0.6f, 1.0f})
        for (const glm::vec3& back : tiny::kBacks) {
            INFO("sheen " << roughness << ", height " << back.z);
            const Material white = velvet(tiny::diffuse(Rgb(1)), Rgb(1), roughness);
            CHECK(tiny::sent(tiny::lit_surface(white, back), 200).x == Approx(1).margin(0.006));
            Material metal = velvet(tiny::mirror(Rgb(1)), {1, 0.5f, 0}, roughness);
            metal.roughness = 0.4f;
            const glm::dvec3 by_metal = tiny::sent(tiny::lit_surface(metal, back), 200);
            CHECK(by_metal.x <= 1.006);
            CHECK(by_metal.z < by_metal.x);
        }
}

TEST_CASE("sheen: black, and that of glass, is none", "[shading]")
{
    for (const Material& material :
         {velvet(tiny::diffuse(Rgb(0.5f)), Rgb(0), 0.5f), velvet(tiny::glass(1.5f), Rgb(1), 0.5f)})
        CHECK(make_bsdf(material, material_factors(material)).layers.sheen == 0);
    const Material white = velvet(tiny::diffuse(Rgb(0.5f)), Rgb(1), 0.5f);
    CHECK(make_bsdf(white, material_factors(white)).layers.sheen == 1);
}
