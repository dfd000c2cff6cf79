#include "render/shading/interaction.h"
#include "render/shading/textured_material.h"
#include "tests/support/tiny_scenes.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

/// The unit square with a texture of four pixels on it: red, green above blue, white.
Scene textured_quad()
{
    Scene scene = tiny::make_scene(tiny::quad());
    scene.mesh.attributes.uv[0] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}}; // v runs down
    scene.images.push_back({"four",
                            2,
                            2,
                            {255, 0, 0, 255, 0, 255, 0, 255, //
                             0, 0, 255, 255, 255, 255, 255, 255}});
    scene.materials[0] = tiny::diffuse(Rgb(0.5f));
    TextureSlot slot;
    slot.sampler.magnify = Filter::nearest;
    scene.materials[0].textures = {slot};
    return scene;
}

/// Colour of the diffuse lobe where a ray straight down meets the square.
Rgb diffuse_at(const tiny::ReadyScene& ready, float x, float y)
{
    Ray ray;
    ray.origin = {x, y, 1};
    ray.direction = {0, 0, -1};
    const std::optional<RayHit> hit = ready.render->rays.nearest(ray);
    REQUIRE(hit);
    return interact(*ready.render, ray, *hit).bsdf().diffuse;
}

} // namespace

TEST_CASE("textured material: each point has its pixel's colour times the factor", "[shading]")
{
    const auto ready = tiny::ready(textured_quad());
    CHECK(diffuse_at(*ready, 0.25f, 0.75f) == Rgb(0.5f, 0, 0));
    CHECK(diffuse_at(*ready, 0.75f, 0.75f) == Rgb(0, 0.5f, 0));
    CHECK(diffuse_at(*ready, 0.25f, 0.25f) == Rgb(0, 0, 0.5f));
    CHECK(diffuse_at(*ready, 0.75f, 0.25f) == Rgb(0.5f));
}

TEST_CASE("textured material: metallic, roughness and transmission are multiplied too", "[shading]")
{
    Scene scene = textured_quad();
    Material& material = scene.materials[0];
    material.metallic = 0.8f;
    material.roughness = 0.6f;
    material.transmission = 0.4f;
    material.textures[0].use = TextureUse::metallic_roughness;
    CHECK(varies(material));
    const MaterialPoint green = material_at(scene, 0, {0.9f, 0.05f}); // lower right: white
    CHECK(green.metallic == 0.8f);
    CHECK(green.roughness == 0.6f);
    const MaterialPoint blue = material_at(scene, 0, {0.05f, 0.05f}); // lower left
    CHECK(blue.metallic == 0.8f);
    CHECK(blue.roughness == 0);
    material.textures[0].use = TextureUse::transmission;
    CHECK(material_at(scene, 0, {0.05f, 0.05f}).transmission == 0);
    CHECK(material_at(scene, 0, {0.9f, 0.05f}).transmission == 0.4f);
}

TEST_CASE("textured material: without a texture that is rendered there are only factors",
          "[shading]")
{
    Scene scene = textured_quad();
    scene.materials[0].textures[0].use = TextureUse::occlusion;
    CHECK_FALSE(varies(scene.materials[0]));
    CHECK(material_at(scene, 0, {0.1f, 0.1f}).base_color == Rgb(0.5f));
    scene.materials[0].textures[0].use = TextureUse::base_color;
    scene.mesh.attributes.uv[0].clear(); // no coordinates: no texture
    CHECK(material_at(scene, 0, {0.1f, 0.1f}).base_color == Rgb(0.5f));
}

TEST_CASE("textured material: colours of vertices multiply the base colour", "[shading]")
{
    Scene scene = textured_quad();
    scene.mesh.attributes.colours.assign(4, glm::vec4(1));
    CHECK(varying_materials(scene) == std::vector<std::uint8_t>{1}); // by its texture
    scene.materials[0].textures.clear();
    CHECK(varying_materials(scene) == std::vector<std::uint8_t>{0}); // white says nothing
    scene.mesh.attributes.colours = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}, {1, 1, 1, 1}};
    CHECK(varying_materials(scene) == std::vector<std::uint8_t>{1});
    const glm::vec2 middle(1.0f / 3);
    const Rgb seen = material_at(scene, 0, middle).base_color;
    for (int c = 0; c < 3; ++c)
        CHECK(seen[c] == Approx(0.5 / 3));
    scene.materials[0].unlit = true;
    scene.materials[0].emission = Rgb(3);
    CHECK(material_at(scene, 0, middle).emission.x == Approx(1));
}

TEST_CASE("textured material: the mean emission of a face is that of its part of the texture",
          "[shading]")
{
    Scene scene = textured_quad();
    scene.materials[0].textures[0].use = TextureUse::emission;
    scene.materials[0].emission = Rgb(8);
    const Rgb below = mean_emission(scene, 0), above = mean_emission(scene, 1);
    const Rgb sum = below + above;
    CHECK(sum.x == Approx(8).epsilon(0.1)); // red and white: a half of the square
    CHECK(sum.y == Approx(8).epsilon(0.1));
    CHECK(sum.z == Approx(8).epsilon(0.1));
    scene.images[0].rgba.assign(16, 0);
    CHECK(mean_emission(scene, 0) == Rgb(0));
}

TEST_CASE("textured material: specular textures scale the coat", "[shading]")
{
    Scene scene = textured_quad();
    Material& material = scene.materials[0];
    material.specular = 1;
    material.textures[0].use = TextureUse::specular_color;
    CHECK(material_at(scene, 0, {0.05f, 0.05f}).specular_color == Rgb(0, 0, 1));
    material.textures[0].use = TextureUse::specular; // alpha, one everywhere
    CHECK(material_at(scene, 0, {0.05f, 0.05f}).specular == 1);
}
