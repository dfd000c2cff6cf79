#include "tests/support/means_of_images.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

Material modelled(ReflectionModel model)
{
    Material material = tiny::diffuse({0.7f, 0.3f, 0.2f});
    material.reflection_model = model;
    material.lobe_specular = Rgb(0.5f);
    material.lobe_exponent = 10;
    return material;
}

void check_ball(const Material& material, bool is_gathered)
{
    Scene scene = tiny::room();
    TriangleMesh ball = tiny::uv_sphere(32, 16);
    tiny::scale(ball, 0.25f);
    tiny::add(scene, ball, material);
    for (const glm::vec3& p : scene.mesh.positions) // round the ball
        scene.mesh.attributes.tangents.emplace_back(-p.z, 0, p.x, 1);
    const auto ready = tiny::ready(scene);
    CHECK(ready->render->directional == is_gathered);
    ImageOptions options;
    options.width = options.height = 16;
    options.photons = 10000;
    check_agreement(*ready, options, 8, 25);
}

} // namespace

TEST_CASE("reflection models: photon maps agree with paths", "[integrator]")
{
    check_ball(modelled(ReflectionModel::phong), true);
    // What Schlick's spreads is gathered, and its mirror makes caustics.
    Material foil = modelled(ReflectionModel::schlick);
    foil.base_color = {0.9f, 0.7f, 0.3f};
    foil.roughness = 0.3f;
    check_ball(foil, true);
}

TEST_CASE("reflection models: photon maps agree with paths on anisotropic lobes", "[integrator]")
{
    Material brushed = modelled(ReflectionModel::ward);
    for (const float narrow : {0.06f, 0.2f}) { // followed and gathered
        brushed.ward_slopes = {0.5f, narrow};
        check_ball(brushed, narrow > 0.09f);
    }
    Material cloth = modelled(ReflectionModel::lafortune); // back to where light comes from
    cloth.lafortune_coefficients = {0.9f, 0.6f, 1};
    check_ball(cloth, true);
}
