#include "tests/support/means_of_images.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>

using namespace hipmap;

TEST_CASE("reflection models: photon maps agree with paths", "[integrator]")
{
    // Phong's is gathered, Schlick's in part, and in part a mirror that makes caustics.
    Material plastic = tiny::diffuse({0.7f, 0.3f, 0.2f});
    plastic.reflection_model = ReflectionModel::phong;
    plastic.phong_specular = Rgb(0.5f);
    plastic.phong_exponent = 10;
    Material foil = tiny::diffuse({0.9f, 0.7f, 0.3f});
    foil.reflection_model = ReflectionModel::schlick;
    foil.roughness = 0.3f;
    for (const Material& material : {plastic, foil}) {
        Scene scene = tiny::room();
        TriangleMesh ball = tiny::uv_sphere(32, 16);
        tiny::scale(ball, 0.25f);
        tiny::add(scene, ball, material);
        const auto ready = tiny::ready(scene);
        CHECK(ready->render->directional);
        ImageOptions options;
        options.width = options.height = 16;
        options.photons = 20000;
        check_agreement(*ready, options, 8, 70);
    }
}
