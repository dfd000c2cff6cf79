#include "preprocess/partition/build_partition.h"
#include "render/effects/convex_solid.h"
#include "render/effects/effect_plan.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

bool is_convex(const TriangleMesh& mesh)
{
    const Scene scene = tiny::make_scene(mesh);
    return is_convex_solid(scene.mesh, build_partition(scene, {}).partition);
}

TriangleMesh moved_cube(const glm::vec3& by)
{
    TriangleMesh mesh = tiny::cube();
    tiny::move(mesh, by);
    return mesh;
}

/// A cube seen by a camera outside, below a point light.
Scene lone_cube(const Material& material)
{
    Scene scene = tiny::make_scene(tiny::cube());
    scene.materials[0] = material;
    scene.cameras[0].position = {0, 0, 3};
    ScenePointLight light;
    light.position = {0, 2, 2};
    light.intensity = Rgb(1);
    scene.lights.push_back(light);
    return scene;
}

bool is_on(Effect effect, const Scene& scene, const EffectOptions& options = {})
{
    return plan_effects(scene, build_partition(scene, {}).partition, options).has(effect);
}

} // namespace

TEST_CASE("is_convex_solid: closed convex surfaces alone, however they are wound and placed",
          "[effects]")
{
    CHECK(is_convex(tiny::cube()));
    CHECK(is_convex(tiny::tetrahedron()));
    CHECK(is_convex(moved_cube({1000, -300, 7})));
    TriangleMesh inside_out = tiny::cube();
    tiny::turn_inside_out(inside_out);
    CHECK(is_convex(inside_out));
    TriangleMesh one_face = tiny::cube();
    tiny::flip(one_face, 3);
    CHECK(is_convex(one_face));
}

TEST_CASE("is_convex_solid: nothing else is", "[effects]")
{
    CHECK_FALSE(is_convex({}));
    CHECK_FALSE(is_convex(tiny::quad()));
    CHECK_FALSE(is_convex(tiny::open_box()));
    CHECK_FALSE(is_convex(tiny::moebius(12)));
    CHECK_FALSE(is_convex(tiny::doubled()));
    CHECK_FALSE(is_convex(tiny::degenerate()));
    CHECK_FALSE(is_convex(tiny::together(tiny::cube(), moved_cube({3, 0, 0}))));
    TriangleMesh inner = tiny::cube();
    tiny::scale(inner, 0.5f);
    CHECK_FALSE(is_convex(tiny::together(tiny::cube(), inner)));

    TriangleMesh dented = tiny::cube();
    const glm::vec3 corner = dented.positions[0];
    for (glm::vec3& position : dented.positions)
        if (position == corner)
            position = 0.1f * corner;
    CHECK_FALSE(is_convex(dented));
}

TEST_CASE("effect plan: a convex solid alone has no indirect light and no caustics", "[effects]")
{
    Material polished = tiny::diffuse(Rgb(0.5f));
    polished.specular = 1;
    polished.roughness = 0;
    CHECK_FALSE(is_on(Effect::indirect, lone_cube(polished)));
    CHECK_FALSE(is_on(Effect::caustics, lone_cube(polished)));
    CHECK(is_on(Effect::mirror, lone_cube(polished)));
    Scene bright = lone_cube(polished);
    bright.materials[0].emission = Rgb(1);
    bright.environment = Rgb(1);
    CHECK_FALSE(is_on(Effect::indirect, bright));
}

TEST_CASE("effect plan: what makes a convex solid light itself or hides behind it counts",
          "[effects]")
{
    const Material plain = tiny::diffuse(Rgb(0.5f));
    REQUIRE_FALSE(is_on(Effect::indirect, lone_cube(plain)));

    Scene on_floor = lone_cube(plain);
    tiny::add(on_floor, tiny::floor_at(-0.5f, 4), plain);
    CHECK(is_on(Effect::indirect, on_floor));

    Scene inside = lone_cube(plain);
    inside.cameras[0].position = {0, 0, 0.4f};
    CHECK(is_on(Effect::indirect, inside));

    Scene cut_open = lone_cube(plain);
    cut_open.cameras[0].near_clip = 3;
    CHECK(is_on(Effect::indirect, cut_open));

    Scene fog = lone_cube(plain);
    fog.around.scattering = Rgb(0.1f);
    CHECK(is_on(Effect::indirect, fog));

    Material half = plain;
    half.alpha_mode = AlphaMode::blend;
    half.alpha = 0.5f;
    CHECK(is_on(Effect::indirect, lone_cube(half)));

    Material leaf = plain;
    leaf.diffuse_transmission = 0.5f;
    CHECK(is_on(Effect::indirect, lone_cube(leaf)));

    EffectOptions moving;
    moving.shutter = true;
    moving.moving = {"cube"};
    CHECK(is_on(Effect::indirect, lone_cube(plain), moving));
}
