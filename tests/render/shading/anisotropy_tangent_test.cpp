#include "common/math/sampling.h"
#include "render/shading/anisotropy_tangent.h"
#include "render/shading/interaction.h"
#include "tests/support/lit_surface.h"
#include "tests/support/tiny_scenes.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

/// The unit square of brushed metal, with a texture upright on it.
Scene brushed_quad()
{
    Scene scene = tiny::make_scene(tiny::quad());
    scene.mesh.attributes.uv[0] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}}; // v runs down
    scene.materials[0] = tiny::mirror(Rgb(0.9f));
    scene.materials[0].roughness = 0.4f;
    scene.materials[0].anisotropy = 0.8f;
    return scene;
}

void add_texture(Scene& scene, std::uint8_t red, std::uint8_t green, std::uint8_t blue)
{
    scene.images.push_back({"brushes", 1, 1, {red, green, blue, 255}});
    TextureSlot slot;
    slot.use = TextureUse::anisotropy;
    slot.image = static_cast<std::uint32_t>(scene.images.size() - 1);
    scene.materials[0].textures = {slot};
}

/// Of no direction: zero.
glm::vec3 along_of(const Scene& scene)
{
    const glm::vec2 middle(0.3f, 0.3f);
    return anisotropy_tangent(scene, surface_point(scene.mesh, 0, middle), middle)
        .value_or(glm::vec3(0));
}

Interaction seen(const Scene& scene)
{
    const auto ready = tiny::ready(scene);
    Ray ray;
    ray.origin = {0.6f, 0.3f, 1};
    ray.direction = glm::normalize(glm::vec3(0.1f, 0.2f, -1));
    return tiny::kept(interact(*ready->render, ray, ready->render->rays.nearest(ray).value()));
}

Facets facets(const Scene& scene)
{
    return std::get<MicrofacetReflection>(seen(scene).bsdf().all[0].lobe).facets;
}

} // namespace

TEST_CASE("anisotropy tangent: it lies along the texture, turned by the rotation", "[shading]")
{
    Scene scene = brushed_quad();
    CHECK(glm::distance(along_of(scene), {1, 0, 0}) < 1e-5f);
    scene.materials[0].anisotropy_rotation = 0.5f * kPi; // towards the texture's top
    CHECK(glm::distance(along_of(scene), {0, 1, 0}) < 1e-5f);
    scene.mesh.attributes.tangents.assign(4, glm::vec4(0, 1, 0, 1));
    CHECK(glm::distance(along_of(scene), {-1, 0, 0}) < 1e-5f);
    scene.mesh.attributes.tangents.assign(4, glm::vec4(0, 1, 0, -1));
    CHECK(glm::distance(along_of(scene), {1, 0, 0}) < 1e-5f);
}

TEST_CASE(
    "anisotropy tangent: a texture gives the direction, before the rotation, and the strength",
    "[shading]")
{
    Scene scene = brushed_quad();
    add_texture(scene, 128, 255, 128); // upwards, half
    CHECK(glm::distance(along_of(scene), {0, 1, 0}) < 0.01f);
    CHECK(facets(scene).alpha_along ==
          Approx(0.16f + 0.84f * (0.8f * 128 / 255) * (0.8f * 128 / 255)));
    scene.materials[0].anisotropy_rotation = 0.5f * kPi;
    CHECK(glm::distance(along_of(scene), {-1, 0, 0}) < 0.01f);
    add_texture(scene, 255, 128, 0); // no strength
    CHECK_FALSE(seen(scene).bsdf().is_directed);
}

TEST_CASE("anisotropy tangent: it lies across the shading normal; none without a direction",
          "[shading]")
{
    Scene scene = brushed_quad();
    const Interaction at = seen(scene);
    CHECK(at.bsdf().is_directed);
    CHECK(glm::distance(at.tangent, {1, 0, 0}) < 1e-5f);

    scene.images.push_back({"bumps", 1, 1, {204, 128, 230, 255}}); // tilted along it
    TextureSlot slot;
    slot.use = TextureUse::normal;
    scene.materials[0].textures = {slot};
    const Interaction tilted = seen(scene);
    REQUIRE(tilted.shading_normal != tilted.normal);
    CHECK(std::abs(glm::dot(tilted.tangent, tilted.shading_normal)) < 1e-5f);
    CHECK(glm::length(tilted.tangent) == Approx(1));

    scene = brushed_quad();
    scene.mesh.attributes.uv[0].clear();
    CHECK(seen(scene).tangent == glm::vec3(0));
    CHECK(facets(scene).alpha == Approx(0.16f));
}
