#include "render/shading/interaction.h"
#include "render/shading/normal_map.h"
#include "tests/support/tiny_scenes.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

/// The unit square with a texture of one pixel on it, upright and not mirrored.
Scene bumpy_quad(std::uint8_t red, std::uint8_t green, std::uint8_t blue)
{
    Scene scene = tiny::make_scene(tiny::quad());
    scene.mesh.attributes.uv[0] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}}; // v runs down
    scene.images.push_back({"bumps", 1, 1, {red, green, blue, 255}});
    scene.materials[0] = tiny::diffuse(Rgb(0.5f));
    TextureSlot slot;
    slot.use = TextureUse::normal;
    scene.materials[0].textures = {slot};
    return scene;
}

// (0.6, 0, 0.8) and (0, 0.6, 0.8) to the nearest step of 1/128.
Scene tilted_right()
{
    return bumpy_quad(204, 128, 230);
}

Scene tilted_up()
{
    return bumpy_quad(128, 204, 230);
}

glm::vec3 normal_of(const Scene& scene)
{
    const glm::vec2 middle(0.3f, 0.3f);
    return mapped_normal(scene, surface_point(scene.mesh, 0, middle), middle);
}

void check_normal(const Scene& scene, const glm::vec3& expected)
{
    const glm::vec3 normal = normal_of(scene);
    CHECK(glm::length(normal) == Approx(1));
    CHECK(glm::distance(normal, expected) < 0.01f);
}

} // namespace

TEST_CASE("normal map: red tilts to the texture's right, green upwards", "[shading]")
{
    check_normal(tilted_right(), {0.6f, 0, 0.8f});
    check_normal(tilted_up(), {0, 0.6f, 0.8f});
    Scene mirrored = tilted_right();
    for (glm::vec2& uv : mirrored.mesh.attributes.uv[0])
        uv.x = 1 - uv.x;
    check_normal(mirrored, {-0.6f, 0, 0.8f});
    Scene mirrored_up = tilted_up();
    mirrored_up.mesh.attributes.uv[0] = mirrored.mesh.attributes.uv[0];
    check_normal(mirrored_up, {0, 0.6f, 0.8f});
    Scene turned = tilted_right(); // a quarter turn: u runs along -v
    turned.materials[0].textures[0].uv_transform = {0, 1, -1, 0, 0, 0};
    CHECK(std::abs(normal_of(turned).y) == Approx(0.6f).margin(0.01));
}

TEST_CASE("normal map: tangents of the file come first", "[shading]")
{
    for (const float hand : {1.0f, -1.0f}) {
        Scene scene = tilted_right();
        scene.mesh.attributes.tangents.assign(4, glm::vec4(0, 1, 0, hand));
        check_normal(scene, {0, 0.6f, 0.8f});
        scene = tilted_up();
        scene.mesh.attributes.tangents.assign(4, glm::vec4(0, 1, 0, hand));
        check_normal(scene, {-0.6f * hand, 0, 0.8f});
    }
    Scene without = tilted_right();
    without.mesh.attributes.tangents.assign(4, glm::vec4(0));
    check_normal(without, {0.6f, 0, 0.8f});
}

TEST_CASE("normal map: strength scales the tilt, what says nothing leaves the normal", "[shading]")
{
    Scene scene = tilted_right();
    scene.materials[0].textures[0].strength = 0.5f;
    check_normal(scene, glm::normalize(glm::vec3(0.3f, 0, 0.8f)));
    scene.mesh.attributes.uv[0].assign(4, glm::vec2(0.5f)); // the texture on a point
    CHECK(normal_of(scene) == glm::vec3(0, 0, 1));
    scene.mesh.attributes.uv[0].clear();
    CHECK(normal_of(scene) == glm::vec3(0, 0, 1));
    CHECK(normal_of(bumpy_quad(255, 128, 0)) == glm::vec3(0, 0, 1)); // into the face
}

TEST_CASE("normal map: a ray sees the tilted normal, from behind its opposite", "[shading]")
{
    const auto ready = tiny::ready(tilted_right());
    CHECK(ready->render->bumpy[0] == 1);
    for (const float side : {1.0f, -1.0f}) {
        Ray ray;
        ray.origin = {0.6f, 0.3f, side};
        ray.direction = {0, 0, -side};
        const std::optional<RayHit> hit = ready->render->rays.nearest(ray);
        REQUIRE(hit);
        const Interaction at = interact(*ready->render, ray, *hit);
        CHECK(glm::distance(at.shading_normal, side * glm::vec3(0.6f, 0, 0.8f)) < 0.01f);
        CHECK(at.cosine == Approx(0.8f).margin(0.01));
        CHECK(at.normal == glm::vec3(0, 0, side));
    }
    Ray grazing; // to which the tilted normal shows its back
    grazing.direction = glm::normalize(glm::vec3(1, 0, -0.5f));
    grazing.origin = glm::vec3(0.6f, 0.3f, 0) - grazing.direction;
    const std::optional<RayHit> hit = ready->render->rays.nearest(grazing);
    REQUIRE(hit);
    CHECK(interact(*ready->render, grazing, *hit).shading_normal == glm::vec3(0, 0, 1));
}
