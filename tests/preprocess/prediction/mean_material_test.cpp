#include "preprocess/prediction/mean_material.h"
#include "tests/support/tiny_scenes.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

MeanMaterial mean_of(const Material& material)
{
    Scene scene;
    scene.materials = {material};
    return mean_materials(scene)[0];
}

} // namespace

TEST_CASE("mean_materials: glass and mirrors store no photon, diffuse and rough surfaces do",
          "[prediction]")
{
    CHECK(stores_photons(mean_of(tiny::diffuse(Rgb(0.5f)))));
    CHECK(!stores_photons(mean_of(tiny::diffuse(Rgb(0)))));
    CHECK(!stores_photons(mean_of(tiny::glass(1.5f))));
    CHECK(!stores_photons(mean_of(tiny::mirror(Rgb(0.9f)))));
    Material metal;
    metal.roughness = 0.5f;
    CHECK(stores_photons(mean_of(metal)));
    metal.roughness = 0.25f;
    CHECK(!stores_photons(mean_of(metal)));
    Material nothing = tiny::diffuse(Rgb(0.5f));
    nothing.boundary = false;
    CHECK(!stores_photons(mean_of(nothing)));
}

TEST_CASE("mean_materials: what makes caustics", "[prediction]")
{
    CHECK(makes_caustics(mean_of(tiny::glass(1.5f))));
    CHECK(makes_caustics(mean_of(tiny::mirror(Rgb(0.9f)))));
    CHECK(!makes_caustics(mean_of(tiny::diffuse(Rgb(0.5f)))));
    Material paint = tiny::diffuse(Rgb(0.5f));
    paint.clearcoat = 1;
    CHECK(makes_caustics(mean_of(paint)));
    CHECK(stores_photons(mean_of(paint)));
}

TEST_CASE("mean_materials: textures count by their mean, a mask by what it covers", "[prediction]")
{
    Scene scene;
    scene.images.push_back({"quarter", 2, 2, {}, {}});
    scene.images[0].rgba = {255, 255, 255, 255, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
    Material material = tiny::diffuse(Rgb(0.8f));
    TextureSlot slot;
    slot.sampler.magnify = Filter::nearest;
    material.textures = {slot};
    material.alpha_mode = AlphaMode::mask;
    scene.materials = {material};
    const MeanMaterial mean = mean_materials(scene)[0];
    CHECK(mean.base_color.x == Approx(0.2f));
    CHECK(mean.opacity == Approx(0.25f));
}
