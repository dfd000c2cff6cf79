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

PlannedEffect media_of(const Scene& scene, const EffectOptions& options = {})
{
    const EffectPlan plan = plan_effects(scene, build_partition(scene, {}).partition, options);
    return plan.effects[static_cast<std::size_t>(Effect::media)];
}

} // namespace

TEST_CASE("effect plan: media are on where light passes them, and named", "[effects][media]")
{
    Scene scene = tiny::furnace();
    CHECK(!media_of(scene).on);
    scene.materials[0].scattering = Rgb(1); // matt: no light gets in
    CHECK(!media_of(scene).on);
    TriangleMesh cube = tiny::cube();
    tiny::scale(cube, 0.2f);
    tiny::add(scene, cube, fog());
    CHECK(media_of(scene).on);
    CHECK(media_of(scene).reason.find("'fog'") != std::string::npos);
    CHECK(!media_of(scene, {parse_effect_switches("-media"), true}).on);
    scene = tiny::furnace();
    scene.around.absorption = Rgb(1);
    CHECK(media_of(scene).reason == "the scene has one around it");
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
