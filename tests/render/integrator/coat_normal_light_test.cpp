#include "tests/support/means_of_images.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

/// A panel of lacquered metal in a room, its coat tilted everywhere.
Scene with_tilted_coat(float coat_roughness)
{
    Scene scene = tiny::room();
    Material lacquer = tiny::mirror({0.9f, 0.5f, 0.3f});
    lacquer.roughness = 0.5f;
    lacquer.clearcoat = 1;
    lacquer.clearcoat_roughness = coat_roughness;
    TextureSlot slot;
    slot.use = TextureUse::clearcoat_normal;
    slot.strength = 0.5f;
    lacquer.textures = {slot};
    tiny::add(scene, tiny::floor_at(-0.1f, 0.5f), lacquer);
    scene.images.push_back({"bumps", 1, 1, {204, 128, 230, 255}});
    scene.mesh.attributes.uv[0].clear();
    for (const glm::vec3& position : scene.mesh.positions)
        scene.mesh.attributes.uv[0].emplace_back(position.x, position.z);
    return scene;
}

} // namespace

TEST_CASE("coat normal: photon maps agree with paths below a tilted coat", "[integrator]")
{
    // Followed, and gathered.
    for (const float coat_roughness : {0.1f, 0.5f}) {
        const auto ready = tiny::ready(with_tilted_coat(coat_roughness));
        ImageOptions options;
        options.width = options.height = 16;
        options.photons = 10000;
        INFO("coat " << coat_roughness);
        check_agreement(*ready, options, 8, 30);
    }
}
