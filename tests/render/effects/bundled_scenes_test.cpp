#include "common/scene/load_scene.h"
#include "preprocess/partition/build_partition.h"
#include "render/effects/effect_plan.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

std::string effects_of(const std::string& file)
{
    const LoadedScene loaded = load_scene(HIPMAP_SOURCE_DIR "/" + file, {});
    return list_effects(
        plan_effects(loaded.scene, build_partition(loaded.scene, {}).partition, {}));
}

} // namespace

TEST_CASE("effect plan: bundled scenes call for what their scripts put into them", "[effects]")
{
    CHECK(effects_of("assets/cornell_diffuse.glb") == "soft-shadows, indirect");
    CHECK(effects_of("assets/glass_globe.glb") == "soft-shadows, indirect, refraction, caustics");
    for (const char* file :
         {"assets/cornell.glb", "assets/cornell_spheres.glb", "experiments/scenes/axis_aligned.glb",
          "experiments/scenes/hexagonal.glb", "experiments/scenes/egg_chair.glb"}) {
        INFO(file);
        CHECK(effects_of(file) == "soft-shadows, indirect, mirror, refraction, caustics");
    }
}
