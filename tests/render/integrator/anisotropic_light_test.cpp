#include "tests/support/means_of_images.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

/// A brushed ball in a room.
Scene with_brushed_ball(float roughness)
{
    Scene scene = tiny::room();
    TriangleMesh ball = tiny::uv_sphere(32, 16);
    tiny::scale(ball, 0.25f);
    Material metal = tiny::mirror({0.9f, 0.7f, 0.4f});
    metal.roughness = roughness;
    metal.anisotropy = 0.8f;
    tiny::add(scene, ball, metal);
    for (const glm::vec3& p : scene.mesh.positions) // round the ball
        scene.mesh.attributes.tangents.emplace_back(-p.z, 0, p.x, 1);
    return scene;
}

} // namespace

TEST_CASE("anisotropic light: photon maps agree with paths on brushed metal", "[integrator]")
{
    for (const float roughness : {0.2f, 0.45f}) { // followed and gathered
        const auto ready = tiny::ready(with_brushed_ball(roughness));
        CHECK(ready->render->directional == (roughness > kFollowedRoughness));
        ImageOptions options;
        options.width = options.height = 16;
        options.photons = 10000;
        check_agreement(*ready, options, 8, 30, {.most_noise = 0.012});
    }
}
