#include "render/lobes/anisotropic_facets.h"
#include "render/lobes/ggx.h"
#include "tests/support/drawn_directions.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_scenes.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace hipmap;

namespace {

Material anisotropic(Material material, float roughness, float strength)
{
    material.roughness = roughness;
    material.anisotropy = strength;
    return material;
}

Material plastic(const Rgb& colour)
{
    Material material = tiny::diffuse(colour);
    material.specular = 1;
    return material;
}

/// Metal, gathered and followed, plastic, and glass.
std::vector<Material> brushed()
{
    return {anisotropic(tiny::mirror({1, 0.8f, 0.3f}), 0.45f, 0.7f),
            anisotropic(tiny::mirror(Rgb(0.9f)), 0.28f, 0.6f),
            anisotropic(plastic({0.8f, 0.5f, 0.2f}), 0.5f, 0.8f),
            anisotropic(tiny::glass(1.5f), 0.4f, 0.6f)};
}

/// The surface seen from `back`, anisotropic aslant to the axes.
Interaction lit(const Material& material, const glm::vec3& back)
{
    Interaction at = tiny::lit_surface(material, back);
    at.tangent = {0.8f, 0.6f, 0};
    return at;
}

const glm::vec3 kStretchedBacks[] = {{0.1f, 0, 1}, {0.7f, 0.5f, 0.5f}, {-0.6f, 0.8f, 0.25f}};

/// All that the lobes send on of light from at.back.
double sent(const Interaction& at, int rows)
{
    double sum = 0;
    tiny::over_sphere(rows, [&](const glm::vec3& in, double solid_angle) {
        for (const Lobes lobes : {Lobes::gathered, Lobes::followed})
            sum += double{scattered(at, in, lobes).value.x} * solid_angle;
    });
    return sum;
}

Lobes lobes_of(const Interaction& at)
{
    return at.gathers() ? Lobes::gathered : Lobes::followed;
}

} // namespace

TEST_CASE("anisotropy: widths are the extension's, and never a mirror's", "[shading]")
{
    const Bsdf half =
        tiny::lit_surface(anisotropic(tiny::mirror(Rgb(1)), 0.6f, 0.5f), kStretchedBacks[0]).bsdf();
    CHECK(half.is_directed);
    const Facets& facets = std::get<MicrofacetReflection>(half.all[0].lobe).facets;
    CHECK(facets.alpha == Approx(0.36f));
    CHECK(facets.alpha_along == Approx(0.36f + 0.64f * 0.25f));
    const Bsdf smooth =
        tiny::lit_surface(anisotropic(tiny::mirror(Rgb(1)), 0, 0.5f), kStretchedBacks[0]).bsdf();
    CHECK(smooth.follows);
    CHECK(std::get<MicrofacetReflection>(smooth.all[0].lobe).facets.alpha > 0);
    CHECK_FALSE(tiny::lit_surface(anisotropic(tiny::mirror(Rgb(1)), 0.6f, 0), {0, 0, 1})
                    .bsdf()
                    .is_directed);
    CHECK_FALSE(tiny::lit_surface(anisotropic(tiny::diffuse(Rgb(1)), 0.6f, 1), {0, 0, 1})
                    .bsdf()
                    .is_directed);
}

TEST_CASE("anisotropy: facets of two equal widths are those of one", "[shading]")
{
    const glm::vec3 normal(0, 0, 1);
    for (const float alpha : {0.02f, 0.3f, 1.0f}) {
        const AnisotropicFacets facets(normal, {0.6f, 0.8f, 0}, alpha, alpha);
        for (std::uint64_t i = 0; i < 300; ++i) {
            RandomSequence random(3, RandomStream::pictures, 0, i);
            const glm::vec3 in =
                direction_from_cosine(0.05f + 0.95f * random.next(), random.next());
            const glm::vec3 out =
                direction_from_cosine(0.05f + 0.95f * random.next(), random.next());
            const glm::vec3 half = sample_facet(normal, out, alpha, random.next2());
            CHECK(facets.distribution(half) ==
                  Approx(ggx_distribution(normal, half, alpha)).epsilon(2e-3));
            CHECK(facets.pdf(out, half) ==
                  Approx(ggx_facet_pdf(normal, out, half, alpha)).epsilon(2e-3));
            CHECK(facets.spread(in, out, half) ==
                  Approx(ggx_distribution(normal, half, alpha) * ggx_visibility(in.z, out.z, alpha))
                      .epsilon(2e-3));
            CHECK(facets.shadowing(in, in.z, out, out.z) ==
                  Approx(ggx_shadowing(in.z, out.z, alpha)).epsilon(1e-4));
        }
    }
}

TEST_CASE("anisotropy: facets cover the surface, and those seen its outline", "[shading]")
{
    const AnisotropicFacets facets({0, 0, 1}, {1, 0, 0}, 0.7f, 0.2f);
    const glm::vec3 out = glm::normalize(glm::vec3(0.7f, 0.5f, 0.3f));
    double covered = 0, seen = 0;
    tiny::over_sphere(500, [&](const glm::vec3& half, double solid_angle) {
        covered += double{facets.distribution(half) * half.z} * solid_angle;
        seen += double{facets.pdf(out, half)} * solid_angle;
    });
    CHECK(covered == Approx(1).margin(1e-3));
    CHECK(seen == Approx(1).margin(1e-3));
}

TEST_CASE("anisotropy: directions are drawn with the pdf that is returned", "[shading]")
{
    for (const Material& material : brushed())
        for (const glm::vec3& back : kStretchedBacks) {
            const Interaction at = lit(material, back);
            CHECK(tiny::chi_square_z(at, lobes_of(at)) < kMostZ);
        }
}

TEST_CASE("anisotropy: the mean weight is the integral of the lobes, none above one", "[shading]")
{
    for (const Material& material : brushed()) {
        const Interaction at = lit(material, kStretchedBacks[1]);
        double integral = 0;
        tiny::over_sphere(300, [&](const glm::vec3& in, double solid_angle) {
            integral += double{scattered(at, in, lobes_of(at)).value.x} * solid_angle;
        });
        RunningMean mean;
        for (std::uint64_t i = 0; i < 20000; ++i) {
            RandomSequence random(5, RandomStream::pictures, 0, i);
            const ScatterSample drawn = sample_scatter(at, lobes_of(at), random);
            mean.add(drawn.weight.x / (drawn.eta * drawn.eta));
            if (at.follows())
                CHECK(drawn.weight.x <= 1 + 1e-4f);
        }
        CHECK(std::abs(mean.mean() - integral) < 0.002 + kMostZ * mean.standard_error());
    }
}

TEST_CASE("anisotropy: light takes the same way back", "[shading]")
{
    const std::vector<Material> materials = brushed();
    for (std::uint64_t i = 0; i < 3000; ++i) {
        RandomSequence random(11, RandomStream::pictures, 0, i);
        const Material& material = materials[i % 3]; // glass has its index between them
        glm::vec3 a = sample_sphere(random.next2()), b = sample_sphere(random.next2());
        a.z = std::abs(a.z);
        b.z = std::abs(b.z);
        const Interaction from_a = lit(material, a), from_b = lit(material, b);
        const float there = scattered(from_a, b, lobes_of(from_a)).value.x / b.z;
        const float back = scattered(from_b, a, lobes_of(from_b)).value.x / a.z;
        CHECK(there == Approx(back).epsilon(2e-3).margin(1e-5));
    }
}

TEST_CASE("anisotropy: no surface sends on more than all, a white base most", "[shading]")
{
    for (const float roughness : {0.25f, 0.5f, 0.7f})
        for (const float strength : {0.3f, 0.6f, 1.0f})
            for (const float cosine : {0.15f, 0.5f, 0.95f})
                for (const float turn : {0.0f, 0.3f, 0.5f}) {
                    const glm::vec3 back =
                        std::sqrt(1 - cosine * cosine) *
                            glm::vec3(std::cos(turn * kPi), std::sin(turn * kPi), 0) +
                        glm::vec3(0, 0, cosine);
                    INFO("roughness " << roughness << ", strength " << strength << ", cosine "
                                      << cosine << ", turn " << turn);
                    Interaction at =
                        tiny::lit_surface(anisotropic(plastic(Rgb(1)), roughness, strength), back);
                    at.tangent = {1, 0, 0};
                    const double white = sent(at, 150);
                    CHECK(white <= 1.005);
                    CHECK(white > (cosine > 0.4f ? 0.8 : 0.5));
                    at.own = tiny::lit_surface(
                                 anisotropic(tiny::mirror(Rgb(1)), roughness, strength), back)
                                 .own;
                    at.tangent = {1, 0, 0};
                    CHECK(sent(at, 150) <= 1.005);
                }
}

TEST_CASE("anisotropy: a brushed metal's highlight is long along the direction", "[shading]")
{
    Interaction at = tiny::lit_surface(anisotropic(tiny::mirror(Rgb(1)), 0.4f, 0.8f), {0, 0, 1});
    at.tangent = {1, 0, 0};
    const glm::vec3 along = glm::normalize(glm::vec3(0.6f, 0, 1)),
                    across = glm::normalize(glm::vec3(0, 0.6f, 1));
    CHECK(scattered(at, along, Lobes::gathered).value.x >
          4 * scattered(at, across, Lobes::gathered).value.x);
}
