#include "bench/predicted_maps.h"
#include "common/scene/load_scene.h"

#include <catch2/catch.hpp>

#include <string>

using namespace hipmap;

namespace {

const ExpectedPass kPass{200'000, 50};

PredictedMaps compare(const std::string& name)
{
    const std::string path = std::string(HIPMAP_SOURCE_DIR) + "/assets/" + name + ".glb";
    return compare_predicted_maps(load_scene(path, {}).scene, kPass);
}

} // namespace

TEST_CASE("predicted maps: most maps of mode thesis are of candidates, most candidates get one",
          "[candidates]")
{
    PredictedMaps all;
    for (const char* name : {"cornell_diffuse", "cornell", "hall_of_lamps", "window_room",
                             "wide_plane", "effects/alpha", "effects/diffuse_transmission",
                             "effects/fog", "effects/reflections", "effects/textures"}) {
        CAPTURE(name);
        const PredictedMaps maps = compare(name);
        CHECK(10 * maps.foreseen >= 9 * maps.built);
        CHECK(2 * maps.used >= maps.candidates);
        CHECK(20 * maps.candidates <= maps.faces + 20 * 30); // not all of a large scene
        all += maps;
    }
    CHECK(all.built > 100);
    CHECK(all.candidates > 50);
}
