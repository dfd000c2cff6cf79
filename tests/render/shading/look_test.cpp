#include "common/scene/look.h"
#include "tests/support/lit_surface.h"
#include "tests/support/tiny_scenes.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

Material like(Look look, Material material)
{
    shade_like(look, material);
    return material;
}

Material painted(const Rgb& colour, float roughness)
{
    Material out = tiny::diffuse(colour);
    out.specular = 1;
    out.roughness = roughness;
    return out;
}

Reflectance reflection_of(const Bsdf& bsdf)
{
    for (const PlacedLobe& placed : bsdf.lobes()) {
        if (const auto* facets = std::get_if<MicrofacetReflection>(&placed.lobe))
            return facets->fresnel;
        if (const auto* mirror = std::get_if<SmoothMirror>(&placed.lobe))
            return mirror->fresnel;
    }
    throw std::logic_error("no reflection");
}

/// The mean share of light over the cosine-weighted hemisphere that a surface sends on.
double mean_sent(const Material& material)
{
    constexpr int kSteps = 16;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
        const float cosine = std::sqrt((static_cast<float>(i) + 0.5f) / kSteps);
        const Interaction at =
            tiny::lit_surface(material, {std::sqrt(1 - cosine * cosine), 0, cosine});
        sum += tiny::sent(at, 128).y + double{specular_lobes(at).mirror.y};
    }
    return sum / kSteps;
}

} // namespace

TEST_CASE("look of Blender 3: the curve of a coat is the dielectric's", "[shading][look]")
{
    // At 60 degrees on index 1.5, cos t = sqrt(1 - 3/9) = 0.816497: perpendicular
    // (0.5 - 1.224745) / (0.5 + 1.224745) = -0.420204, parallel
    // (0.75 - 0.816497) / (0.75 + 0.816497) = -0.042449, mean of squares 0.089186.
    const Material paint = like(Look::blender_3_4, painted(Rgb(0.5f), 0.4f));
    const Reflectance coat = reflection_of(make_bsdf(paint, material_factors(paint)));
    CHECK(coat(1).x == Approx(0.04));
    CHECK(coat(0.5f).x == Approx(0.089186).epsilon(1e-4));
    CHECK(coat(0).x == Approx(1));
    // A metal is (0.089186 - 0.04) / 0.96 of the way from its colour to white.
    Material gold = like(Look::blender_3_4, tiny::mirror({1, 0.8f, 0.3f}));
    const Reflectance metal = reflection_of(make_bsdf(gold, material_factors(gold)));
    CHECK(metal(0.5f).z == Approx(0.3 + 0.7 * 0.0512354).epsilon(1e-4));
    gold.specular = 0;
    CHECK(reflection_of(make_bsdf(gold, material_factors(gold)))(0.5f).z == Approx(0.3f));
}

TEST_CASE("look: averages of reflectances are the integrals of their curves", "[shading][look]")
{
    for (const float index : {0.0f, 1.001f, 1.2f, 1.5f, 3.5f}) {
        const Reflectance of{Rgb(0.2f), Rgb(1), index};
        double sum = 0;
        constexpr int kSteps = 20000;
        for (int i = 0; i < kSteps; ++i)
            sum += of(std::sqrt((static_cast<float>(i) + 0.5f) / kSteps)).x;
        INFO("index " << index);
        CHECK(of.average().x == Approx(sum / kSteps).epsilon(2e-4));
    }
}

TEST_CASE("look of Blender 3: a coat adds to an unchanged base", "[shading][look]")
{
    for (const float roughness : {0.0f, 0.2f, 0.5f, 1.0f}) {
        const Material paint = painted({0.6f, 0.3f, 0.1f}, roughness);
        const Material old = like(Look::blender_3_4, paint);
        const Bsdf bsdf = make_bsdf(old, material_factors(old));
        CHECK(bsdf.diffuse == paint.base_color);
        CHECK_FALSE(bsdf.layers.any);
        const Bsdf darkened = make_bsdf(paint, material_factors(paint));
        CHECK(darkened.layers.any);
        // Light that leaves the base of glTF's paint passes the coat twice.
        CHECK(tiny::sent(tiny::lit_surface(old, {0.6f, 0, 0.8f}), 128).y >
              tiny::sent(tiny::lit_surface(paint, {0.6f, 0, 0.8f}), 128).y);
    }
}

TEST_CASE("look of Blender 3: a white base loses what would exceed the light received",
          "[shading][look]")
{
    for (const float roughness : {0.0f, 0.3f, 0.6f, 1.0f})
        for (const float clearcoat : {0.0f, 1.0f}) {
            Material white = like(Look::blender_3_4, painted(Rgb(1), roughness));
            white.clearcoat = clearcoat;
            white.clearcoat_roughness = 0.3f;
            INFO("roughness " << roughness << ", clear coat " << clearcoat);
            const double sent = mean_sent(white);
            CHECK(sent < 1.005);
            CHECK(sent > 0.96);
        }
}

TEST_CASE("look of Blender 4: two crossings tint by the base colour", "[shading][look]")
{
    Material green = tiny::glass(1.5f);
    green.base_color = {0.25f, 0.81f, 1};
    const auto tint_of = [&](Look look) {
        const Material glass = like(look, green);
        const Bsdf bsdf = make_bsdf(glass, material_factors(glass));
        return std::get<SmoothDielectric>(bsdf.all[0].lobe).tint;
    };
    CHECK(tint_of(Look::gltf) == green.base_color);
    CHECK(tint_of(Look::blender_3_6) == green.base_color);
    CHECK(tint_of(Look::blender_4).x == Approx(0.5));
    CHECK(tint_of(Look::blender_4).y == Approx(0.9));
}

TEST_CASE("look of Blender 3: a clear coat has a quarter of its factor", "[shading][look]")
{
    const auto mirror_of = [](Look look) {
        Material lacquer = tiny::diffuse(Rgb(0.5f));
        lacquer.clearcoat = 1;
        const Material material = like(look, lacquer);
        return specular_lobes(tiny::lit_surface(material, {0, 0, 1})).mirror.x;
    };
    CHECK(mirror_of(Look::gltf) == Approx(0.04));
    CHECK(mirror_of(Look::blender_4) == Approx(0.04));
    CHECK(mirror_of(Look::blender_3_4) == Approx(0.01));
}
