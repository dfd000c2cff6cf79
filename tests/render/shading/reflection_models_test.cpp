#include "render/lobes/cosine_power.h"
#include "render/lobes/schlick.h"
#include "tests/support/drawn_directions.h"
#include "tests/support/drawn_weights.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_scenes.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

Material phong(const Rgb& base, const Rgb& specular, float exponent)
{
    Material material = tiny::diffuse(base);
    material.reflection_model = ReflectionModel::phong;
    material.lobe_specular = specular;
    material.lobe_exponent = exponent;
    return material;
}

Material schlick(const Rgb& base, float roughness, float isotropy = 1)
{
    Material material = tiny::diffuse(base);
    material.reflection_model = ReflectionModel::schlick;
    material.roughness = roughness;
    material.isotropy = isotropy;
    return material;
}

Material ward(const Rgb& base, const Rgb& specular, const glm::vec2& slopes)
{
    Material material = phong(base, specular, 0);
    material.reflection_model = ReflectionModel::ward;
    material.ward_slopes = slopes;
    return material;
}

Material lafortune(const Rgb& base, const Rgb& specular, float exponent,
                   const glm::vec3& coefficients)
{
    Material material = phong(base, specular, exponent);
    material.reflection_model = ReflectionModel::lafortune;
    material.lafortune_coefficients = coefficients;
    return material;
}

/// As tiny::lit_surface, with a direction to be anisotropic along.
Interaction lit_model(const Material& material, const glm::vec3& back)
{
    Interaction at = tiny::lit_surface(material, back);
    at.tangent = {0.6f, 0.8f, 0};
    return at;
}

/// Gathered and followed, of each model.
std::vector<Material> all_models()
{
    return {phong({0.8f, 0.5f, 0.2f}, {0.3f, 0.6f, 0.1f}, 0),
            phong({0.8f, 0.5f, 0.2f}, {0.2f, 0.4f, 0.9f}, 12),
            phong({0.1f, 0.3f, 0.2f}, Rgb(0.7f), 90),
            schlick({0.9f, 0.6f, 0.2f}, 0.15f),
            schlick({0.9f, 0.6f, 0.2f}, 0.5f, 0.3f),
            schlick({0.2f, 0.4f, 0.9f}, 0.8f),
            schlick(Rgb(0), 1),
            schlick({0.8f, 0.4f, 0.9f}, 0.006f),
            ward({0.8f, 0.5f, 0.2f}, {0.2f, 0.4f, 0.9f}, {0.4f, 0.15f}),
            ward({0.1f, 0.3f, 0.2f}, Rgb(0.7f), {0.08f, 0.5f}),
            lafortune({0.8f, 0.5f, 0.2f}, {0.2f, 0.4f, 0.9f}, 12, {-0.7f, -1, 0.9f}),
            lafortune({0.1f, 0.3f, 0.2f}, Rgb(0.7f), 90, {-1, -1, 1})};
}

const glm::vec3 kModelBacks[] = {{0.1f, 0, 1}, {0.7f, -0.4f, 0.6f}, {-1, 0.2f, 0.15f}};

Lobes model_lobes_of(const Interaction& at)
{
    return at.follows() ? Lobes::followed : Lobes::gathered;
}

/// f(in, back) of what is gathered.
double value_at(const Interaction& at, const glm::vec3& in)
{
    return scattered(at, in, Lobes::gathered).value.x / in.z;
}

} // namespace

TEST_CASE("reflection models: Phong's values by hand", "[shading]")
{
    const double pi = std::numbers::pi;
    const Interaction at = lit_model(phong(Rgb(0.4f), Rgb(0.5f), 2), {0.6f, 0, 0.8f});
    CHECK(value_at(at, {-0.6f, 0, 0.8f}) == Approx((0.4 * 0.5 + 0.5 * 2) / pi)); // the mirror image
    CHECK(value_at(at, {0, 0, 1}) == Approx((0.4 * 0.5 + 0.5 * 2 * 0.64) / pi));
    CHECK(value_at(at, {0.8f, 0, 0.6f}) == Approx(0.4 * 0.5 / pi)); // a right angle from it
    const Interaction even = lit_model(phong(Rgb(0), Rgb(1), 0), {0, 0, 1});
    CHECK(value_at(even, {0.6f, 0, 0.8f}) == Approx(1 / pi));
}

TEST_CASE("reflection models: Schlick's values by hand", "[shading]")
{
    const double pi = std::numbers::pi;
    const glm::vec3 up(0, 0, 1);
    const Interaction smooth = lit_model(schlick(Rgb(0.3f), 0.2f), up); // a 0, b 0.64, c 0.36
    CHECK(value_at(smooth, up) == Approx(0.3 * 0.64 * 5 / (4 * pi)));
    CHECK(specular_lobes(smooth).mirror.x == Approx(0.3 * 0.36));
    const Interaction rough = lit_model(schlick(Rgb(0.3f), 0.8f), up); // a 0.36, b 0.64, c 0
    CHECK(value_at(rough, up) == Approx(0.3 * (0.36 + 0.64 * 1.25 / 4) / pi));
    CHECK(specular_lobes(rough).mirror == Rgb(0));
    const Interaction aslant = lit_model(schlick(Rgb(0.3f), 0.2f), {0.6f, 0, 0.8f});
    const double masking = std::sqrt(0.2) / 2 * 0.2 + 0.8, reflected = 0.3 + 0.7 * std::pow(0.2, 5);
    CHECK(value_at(aslant, {-0.6f, 0, 0.8f}) ==
          Approx(reflected * 0.64 * 5 / (4 * pi * masking * masking)));
}

TEST_CASE("reflection models: Schlick's layer is anisotropic by its isotropy", "[shading]")
{
    const Schlick even{{Rgb(1), Rgb(1)}, 0.5f, 1}, brushed{{Rgb(1), Rgb(1)}, 0.5f, 0.25f};
    const LobeView view{.normal = {0, 0, 1}, .out = {0, 0, 1}, .tangent = {1, 0, 0}};
    const auto ratio = [&](const glm::vec3& half) {
        const glm::vec3 in = reflect(view.out, half);
        return brushed.eval(view, in).x / even.eval(view, in).x;
    };
    CHECK(ratio({0.28f, 0, 0.96f}) == Approx(2));   // 1/sqrt(p)
    CHECK(ratio({0, 0.28f, 0.96f}) == Approx(0.5)); // sqrt(p)
    CHECK(ratio(glm::normalize(glm::vec3(0.2f, 0.2f, 1))) ==
          Approx(std::sqrt(2 * 0.25 / (1 + 0.0625))));
}

TEST_CASE("reflection models: light takes the same way back", "[shading]")
{
    tiny::there_and_back(all_models(), [](float there, float back) {
        CHECK(there == Approx(back).epsilon(2e-3).margin(1e-5));
    });
}

TEST_CASE("reflection models: directions are drawn with the pdf that is returned", "[shading]")
{
    for (const Material& material : all_models())
        for (const glm::vec3& back : {kModelBacks[0], kModelBacks[2]}) {
            const Interaction at = lit_model(material, back);
            INFO("exponent " << material.lobe_exponent << ", roughness " << material.roughness
                             << ", height " << back.z);
            CHECK(tiny::chi_square_z(at, model_lobes_of(at)) < kMostZ);
        }
    for (const Material& material : {all_models()[1], all_models()[3]})
        CHECK(tiny::chi_square_z(tiny::tilted_surface(material, {0.8f, 0, 0.6f}), Lobes::gathered) <
              kMostZ);
}

TEST_CASE("reflection models: the mean weight is the integral of the lobes", "[shading]")
{
    for (const Material& material : all_models()) {
        const Interaction at = lit_model(material, kModelBacks[1]);
        const Lobes lobes = model_lobes_of(at);
        const auto [integral, mean] = tiny::integral_and_weights(at, lobes);
        INFO("exponent " << material.lobe_exponent << ", roughness " << material.roughness);
        CHECK(std::abs(mean.mean() - integral) < 0.002 + kMostZ * mean.standard_error());
    }
}

TEST_CASE("reflection models: no surface sends on more than it gets", "[shading]")
{
    const glm::vec3 backs[] = {{0, 0, 1}, {0.6f, 0.3f, 0.7f}, {-1, 0.2f, 0.15f}, {1, 0.3f, 0.02f}};
    const auto all = [](const Interaction& at) {
        return tiny::sent(at, 150).x + specular_lobes(at).mirror.x;
    };
    for (const glm::vec3& back : backs) {
        for (const float exponent : {0.0f, 3.0f, 40.0f})
            for (const float specular : {0.3f, 1.0f}) {
                INFO("exponent " << exponent << ", height " << back.z);
                const double sum = all(lit_model(phong(Rgb(1), Rgb(specular), exponent), back));
                CHECK(sum <= 1.002);
                if (back.z == 1)
                    CHECK(sum == Approx(1).margin(0.002));
            }
        for (const glm::vec2& slopes : {glm::vec2(0.1f), glm::vec2(0.5f), glm::vec2(1),
                                        glm::vec2(1, 0.1f), glm::vec2(0.1f, 0.4f)}) {
            INFO("slopes " << slopes.x << " and " << slopes.y << ", height " << back.z);
            CHECK(all(lit_model(ward(Rgb(1), Rgb(0.3f), slopes), back)) <= 1.002);
            CHECK(all(lit_model(ward(Rgb(1), Rgb(1), slopes), back)) <= 1.002);
        }
        for (const float exponent : {0.0f, 3.0f, 40.0f})
            for (const glm::vec3& coefficients :
                 {glm::vec3(-1, -0.5f, 0.8f), glm::vec3(1, 1, 1), glm::vec3(-1, 1, 0)}) {
                INFO("exponent " << exponent << ", height " << back.z);
                CHECK(all(lit_model(lafortune(Rgb(1), Rgb(1), exponent, coefficients), back)) <=
                      1.002);
            }
        // By Schlick's own masking it would be up to 1.2 at a roughness of 0.03.
        for (const float roughness : {0.03f, 0.2f, 0.5f, 0.7f, 1.0f})
            for (const float isotropy : {1.0f, 0.4f, 0.05f}) {
                INFO("roughness " << roughness << ", isotropy " << isotropy << ", height "
                                  << back.z);
                CHECK(all(lit_model(schlick(Rgb(1), roughness, isotropy), back)) <= 1.002);
            }
    }
    CHECK(all(lit_model(schlick(Rgb(1), 1), kModelBacks[1])) == Approx(1).margin(0.002));
}

TEST_CASE("reflection models: what becomes of the lobe goes by the roughness it is worth",
          "[shading]")
{
    const auto made = [](const Material& material) {
        return make_bsdf(material, material_factors(material));
    };
    CHECK(cosine_power_roughness(0) == 1);
    CHECK(reflects(made(phong(Rgb(1), Rgb(0.5f), 61)), Lobes::gathered));
    CHECK(reflects(made(phong(Rgb(1), Rgb(0.5f), 62)), Lobes::followed));
    CHECK(made(phong(Rgb(1), Rgb(0), 5)).is_diffuse);
    const Bsdf mirror = made(phong(Rgb(1), Rgb(0.5f), 1e7f));
    CHECK(has_mirror(mirror));
    CHECK(specular(mirror.single(Lobes::specular)->lobe, {.cosine = 0.5f}).mirror.x ==
          Approx(0.25));
    CHECK(reflects(made(lafortune(Rgb(1), Rgb(0.5f), 61, {1, 1, 0.5f})), Lobes::gathered));
    CHECK(reflects(made(lafortune(Rgb(1), Rgb(0.5f), 62, {1, 1, 0.5f})), Lobes::followed));
    CHECK(reflects(made(lafortune(Rgb(1), Rgb(0.5f), 1e9f, {1, 1, 1})), Lobes::followed));
    CHECK(reflects(made(ward(Rgb(1), Rgb(0.5f), {0.0901f, 0.5f})), Lobes::gathered));
    CHECK(reflects(made(ward(Rgb(1), Rgb(0.5f), {0.5f, 0.0899f})), Lobes::followed));
    CHECK(reflects(made(ward(Rgb(1), Rgb(0.5f), {0.5f, 1e-9f})), Lobes::followed));
    const Bsdf steel = made(ward(Rgb(1), Rgb(0.5f), {1e-4f, 3e-4f}));
    CHECK(has_mirror(steel));
    CHECK(specular(steel.single(Lobes::specular)->lobe, {.cosine = 0.5f}).mirror == Rgb(0.5f));
    CHECK(reflects(made(schlick(Rgb(1), 0.0082f)), Lobes::gathered));
    CHECK(reflects(made(schlick(Rgb(1), 0.008f)), Lobes::followed));
    const Bsdf polished = made(schlick(Rgb(0.5f), 0));
    CHECK(has_mirror(polished));
    CHECK_FALSE(polished.gathers);
    CHECK(specular(polished.all[0].lobe, {.cosine = 0.5f}).mirror.x ==
          Approx(0.5 + 0.5 * std::pow(0.5, 5)));
    CHECK(has_mirror(made(schlick(Rgb(0.5f), 0.4f))));
    CHECK_FALSE(has_mirror(made(schlick(Rgb(0.5f), 0.6f))));
}
