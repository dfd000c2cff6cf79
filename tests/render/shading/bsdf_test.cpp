#include "common/math/random.h"
#include "common/math/sampling.h"
#include "render/shading/scatter.h"
#include "tests/support/tiny_scenes.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

Bsdf bsdf_of(const Material& material)
{
    return make_bsdfs({material})[0];
}

/// A flat surface seen under an angle.
Interaction seen(const Bsdf& bsdf, float cosine, bool front = true, bool solid = true)
{
    Interaction at;
    at.own = bsdf;
    at.ior = bsdf.ior;
    at.normal = at.shading_normal = {0, 0, 1};
    at.back = {std::sqrt(1 - cosine * cosine), 0, cosine};
    at.cosine = cosine;
    at.front = front;
    at.solid = solid;
    return at;
}

/// Share of light from a direction that the surface sends on, all lobes together.
Rgb total_albedo(const Bsdf& bsdf, float cosine)
{
    const Interaction at = seen(bsdf, cosine);
    const SpecularLobes lobes = specular_lobes(at);
    return scattered_share(at, Lobes::gathered) + scattered_share(at, Lobes::followed) +
           lobes.mirror + lobes.transmit;
}

} // namespace

TEST_CASE("bsdf: no surface sends on more light than it receives", "[shading]")
{
    for (std::uint64_t i = 0; i < 20000; ++i) {
        RandomSequence random(11, RandomStream::pictures, 0, i);
        Material material;
        material.base_color = {random.next(), random.next(), 1.0f};
        material.metallic = random.next() < 0.3f ? 0.0f : random.next();
        material.transmission = random.next() < 0.3f ? 0.0f : random.next();
        material.roughness = random.next() < 0.5f ? 0.0f : random.next();
        material.ior = 1 + 2 * random.next();
        material.specular = random.next();
        material.specular_color = {random.next(), 1.0f, random.next()};
        const Rgb albedo = total_albedo(bsdf_of(material), random.next());
        CHECK(max_channel(albedo) <= 1 + 1e-5f);
        CHECK(std::min({albedo.x, albedo.y, albedo.z}) >= 0);
    }
}

TEST_CASE("bsdf: white, clear and lossless surfaces send on all of it", "[shading]")
{
    Material glass = tiny::glass(1.5f);
    Material white_mirror = tiny::mirror(Rgb(1));
    for (const Material& material : {glass, white_mirror, tiny::diffuse(Rgb(1))})
        for (float cosine = 0.01f; cosine <= 1; cosine += 0.01f)
            CHECK(total_albedo(bsdf_of(material), cosine).x == Approx(1.0).epsilon(1e-5));
}

TEST_CASE("bsdf: a white diffuse surface under a smooth coat absorbs nothing", "[shading]")
{
    Material coated = tiny::diffuse(Rgb(1));
    coated.specular = 1;
    coated.roughness = 0;
    const Bsdf bsdf = bsdf_of(coated);
    REQUIRE(bsdf.layers.coated);
    for (float cosine = 0.05f; cosine <= 1; cosine += 0.05f)
        CHECK(total_albedo(bsdf, cosine).y == Approx(1.0).epsilon(1e-5));
    // The closed average behind that: the mean of what gets through over the cosine-weighted
    // hemisphere.
    double sum = 0;
    const int n = 100000;
    for (int i = 0; i < n; ++i)
        sum += transmitted_by(bsdf.layers, Depth::diffuse,
                              std::sqrt((static_cast<float>(i) + 0.5f) / n))
                   .x;
    CHECK(sum / n == Approx(bsdf.layers.diffuse_average.x).epsilon(1e-4));
}

TEST_CASE("bsdf: roughness decides between mirror, followed and gathered", "[shading]")
{
    Material metal = tiny::mirror(Rgb(0.9f));
    const auto kind_at = [&](float roughness) {
        metal.roughness = roughness;
        return bsdf_of(metal).all[0].handled;
    };
    CHECK(kind_at(kMirrorRoughness) == Lobes::specular);
    CHECK(kind_at(0.03f) == Lobes::followed);
    CHECK(kind_at(kFollowedRoughness) == Lobes::followed);
    CHECK(kind_at(0.31f) == Lobes::gathered);
    CHECK_FALSE(has_reflection(bsdf_of(tiny::diffuse(Rgb(0.5f)))));
    CHECK_FALSE(bsdf_of(tiny::diffuse(Rgb(0.5f))).layers.coated);
}

TEST_CASE("fresnel: closed values at normal, Brewster's and grazing incidence", "[shading]")
{
    CHECK(fresnel_dielectric(1, 1.5f) == Approx(0.04));
    CHECK(fresnel_dielectric(1, 1 / 1.5f) == Approx(0.04));
    CHECK(fresnel_dielectric(0, 1.5f) == Approx(1.0));
    // At Brewster's angle only the perpendicular part is left: ((n^2-1)/(n^2+1))^2 / 2.
    const double n2 = 1.5 * 1.5;
    const auto brewster = static_cast<float>(1 / std::sqrt(1 + n2));
    CHECK(fresnel_dielectric(brewster, 1.5f) ==
          Approx(0.5 * std::pow((n2 - 1) / (n2 + 1), 2)).epsilon(1e-4));
    // Beyond the critical angle from inside: all.
    CHECK(fresnel_dielectric(std::sqrt(1 - 0.7f * 0.7f), 1 / 1.5f) == 1);
}

TEST_CASE("refract: Snell's law, and back again the same way", "[shading]")
{
    const glm::vec3 normal(0, 0, 1);
    for (float sine = 0; sine < 1; sine += 0.05f) {
        const glm::vec3 from(sine, 0, std::sqrt(1 - sine * sine));
        const glm::vec3 inside = refract(from, normal, 1.5f);
        CHECK(inside.x == Approx(-sine / 1.5f).margin(1e-6));
        CHECK(inside.z < 0);
        const glm::vec3 back = refract(inside, -normal, 1 / 1.5f);
        CHECK(back.x == Approx(from.x).margin(1e-5));
        CHECK(back.z == Approx(from.z).margin(1e-5));
    }
}

TEST_CASE("bsdf: a thin wall lets light through straight", "[shading]")
{
    const Bsdf bsdf = bsdf_of(tiny::glass(1.5f));
    CHECK(specular_lobes(seen(bsdf, 0.5f, true, false)).eta == 1);
    CHECK(specular_lobes(seen(bsdf, 0.5f, false, false)).eta == 1);
    CHECK(specular_lobes(seen(bsdf, 0.5f, true, true)).eta == 1.5f);
    CHECK(specular_lobes(seen(bsdf, 0.9f, false, true)).eta == Approx(1 / 1.5));
    // Total reflection exists only inside a solid.
    CHECK(is_black(specular_lobes(seen(bsdf, 0.1f, false, true)).transmit));
    CHECK(specular_lobes(seen(bsdf, 0.1f, false, false)).transmit.x > 0);
}

TEST_CASE("diffuse shape: reciprocal, closed values for Burley", "[shading]")
{
    const glm::vec3 normal(0, 0, 1);
    Material plaster = tiny::diffuse(Rgb(0.8f));
    plaster.diffuse_model = DiffuseModel::burley;
    const Bsdf bsdf = bsdf_of(plaster);
    const auto burley = [&](const glm::vec3& wi, const glm::vec3& wo) {
        return std::get<Burley>(bsdf.all[0].lobe).shape({normal, wo, wo.z}, wi);
    };
    for (std::uint64_t i = 0; i < 1000; ++i) {
        RandomSequence random(2, RandomStream::pictures, 0, i);
        const glm::vec3 wi = sample_cosine_hemisphere(random.next2());
        const glm::vec3 wo = sample_cosine_hemisphere(random.next2());
        CHECK(burley(wi, wo) == Approx(burley(wo, wi)));
        CHECK(burley(wi, wo) > 0);
    }
    // Roughness 1: straight down nothing changes; grazing and back again 2.5 times 2.5.
    CHECK(burley(normal, normal) == 1);
    const glm::vec3 grazing(1, 0, 0);
    CHECK(burley(grazing, grazing) == Approx(2.5 * 2.5));
    CHECK(burley(grazing, -grazing) == Approx(0.5 * 0.5));
}
