#include "render/effects/drop_effects.h"
#include "render/effects/effect_plan.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

Material fog()
{
    Material out;
    out.name = "fog";
    out.boundary = false;
    out.scattering = Rgb(1);
    return out;
}

PlannedEffect planned(const Scene& scene, Effect effect, const EffectOptions& options = {})
{
    const EffectPlan plan = plan_effects(scene, build_partition(scene, {}).partition, options);
    return plan.effects[static_cast<std::size_t>(effect)];
}

PlannedEffect media_of(const Scene& scene, const EffectOptions& options = {})
{
    return planned(scene, Effect::media, options);
}

TriangleMesh ball_at(float x, float radius)
{
    TriangleMesh ball = tiny::uv_sphere(24, 12);
    tiny::scale(ball, radius);
    tiny::move(ball, {x, 0, 0});
    return ball;
}

/// Two balls of glass.
Scene two_balls(const TriangleMesh& a, const TriangleMesh& b)
{
    Scene scene = tiny::make_scene(a);
    scene.materials[0] = tiny::glass(1.5f);
    scene.materials[0].name = "one";
    Material other = tiny::glass(1.3f);
    other.name = "other";
    tiny::add(scene, b, other);
    return scene;
}

} // namespace

TEST_CASE("effect plan: media are on where light passes them, and named", "[effects][media]")
{
    Scene scene = tiny::furnace();
    CHECK(!media_of(scene).on);
    scene.materials[0].scattering = Rgb(1); // diffuse: no light gets in
    CHECK(!media_of(scene).on);
    TriangleMesh cube = tiny::cube();
    tiny::scale(cube, 0.2f);
    tiny::add(scene, cube, fog());
    CHECK(media_of(scene).on);
    CHECK(media_of(scene).reason.find("'fog'") != std::string::npos);
    CHECK(!media_of(scene, {parse_effect_switches("-media"), true}).on);
    scene = tiny::furnace();
    scene.around.absorption = Rgb(1);
    CHECK(media_of(scene).reason == "a medium surrounds the scene");
}

TEST_CASE("drop_effects: media left out leave neither fog nor the surface it had not",
          "[effects][media]")
{
    Scene scene = tiny::make_scene(tiny::cube());
    scene.materials[0] = fog();
    scene.around.scattering = Rgb(1);
    const Partition partition = build_partition(scene, {}).partition;
    CHECK(RenderScene(scene, partition).media);
    drop_effects(scene, plan_effects(scene, partition, {parse_effect_switches("-media"), true}));
    const RenderScene without(scene, partition);
    CHECK(!without.media);
    Ray ray;
    ray.origin = {0.1f, 0.2f, 2};
    ray.direction = {0, 0, -1};
    CHECK(!without.rays.occluded(ray));
    CHECK(!without.rays.nearest(ray));
}

TEST_CASE("effect plan: light is scattered beneath surfaces that it gets through, and nowhere else",
          "[effects][media]")
{
    Scene scene = tiny::make_scene(tiny::cube());
    Material& wax = scene.materials[0] = tiny::diffuse(Rgb(0.5f));
    wax.name = "wax";
    wax.scattering = Rgb(1);
    CHECK(!planned(scene, Effect::subsurface).on);
    for (float Material::*way : {&Material::transmission, &Material::diffuse_transmission}) {
        wax.*way = 1;
        CHECK(planned(scene, Effect::subsurface).on);
        CHECK(planned(scene, Effect::subsurface).reason.find("'wax'") != std::string::npos);
        CHECK(!media_of(scene).on);
        wax.*way = 0;
    }
    wax.diffuse_transmission = 1;
    const Partition partition = build_partition(scene, {}).partition;
    CHECK(RenderScene(scene, partition).media);
    Scene without = scene;
    drop_effects(without,
                 plan_effects(scene, partition, {parse_effect_switches("-subsurface"), true}));
    CHECK(!RenderScene(without, partition).media);
    scene.mesh.corners.pop_back(); // open: it has no inside
    scene.mesh.material_of_face.pop_back();
    scene.mesh.object_of_face.pop_back();
    CHECK(!planned(scene, Effect::subsurface).on);
}

TEST_CASE("effect plan: dielectrics are nested where one lies in another, or they overlap",
          "[effects][media]")
{
    const TriangleMesh ball = ball_at(0, 0.4f);
    const auto nested = [](const Scene& scene) {
        return planned(scene, Effect::nested_dielectrics);
    };
    CHECK(nested(two_balls(ball, ball_at(0.5f, 0.3f))).on);
    CHECK(nested(two_balls(ball, ball_at(0.1f, 0.2f))).on);
    CHECK(nested(two_balls(ball_at(0.1f, 0.2f), ball)).reason ==
          "'one' and 'other' overlap each other");
    CHECK(!nested(two_balls(ball, ball_at(0.8f, 0.3f))).on);
    // Boxes overlap, balls do not.
    TriangleMesh aside = ball_at(0.55f, 0.3f);
    tiny::move(aside, {0, 0.5f, 0});
    CHECK(!nested(two_balls(ball, aside)).on);
    TriangleMesh hollow = ball_at(0, 0.3f);
    tiny::turn_inside_out(hollow);
    CHECK(!nested(two_balls(ball, hollow)).on);
    // A drop in the wall of the hollow ball.
    Scene with_drop = two_balls(ball, hollow);
    with_drop.mesh.material_of_face.assign(with_drop.mesh.face_count(), 0);
    tiny::add(with_drop, ball_at(0.35f, 0.02f), tiny::glass(1.3f));
    CHECK(nested(with_drop).on);
    Scene diffuse_inside = two_balls(ball, ball_at(0.1f, 0.2f));
    diffuse_inside.materials[1] = tiny::diffuse(Rgb(0.5f));
    CHECK(!nested(diffuse_inside).on);
}

TEST_CASE("drop_effects: rays know what they are in only where dielectrics are nested",
          "[effects][media]")
{
    Scene scene = two_balls(ball_at(0, 0.4f), ball_at(0.1f, 0.2f));
    const Partition partition = build_partition(scene, {}).partition;
    drop_effects(scene, plan_effects(scene, partition, {}));
    CHECK(RenderScene(scene, partition).has_nested());
    drop_effects(scene, plan_effects(scene, partition,
                                     {parse_effect_switches("-nested-dielectrics"), true}));
    CHECK(!RenderScene(scene, partition).media);
}
