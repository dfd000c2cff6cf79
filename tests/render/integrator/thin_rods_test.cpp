#include "tests/support/means_of_images.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

/// A room whose only lamp looks up, and a smooth rod below it, twenty times as long as wide, that
/// fills the picture.
Scene lit_rod()
{
    Scene scene = tiny::box(tiny::diffuse({0.7f, 0.6f, 0.5f}));
    tiny::add(scene, tiny::floor_at(0.3f, 0.4f), tiny::emissive(Rgb(8)));
    TriangleMesh rod = tiny::uv_sphere(64, 32);
    for (glm::vec3& position : rod.positions)
        position = glm::vec3(0.4f, 0.02f, 0.02f) * glm::vec3(position.y, position.z, position.x);
    tiny::add(scene, rod, tiny::diffuse({0.5f, 0.6f, 0.7f}));
    scene.cameras[0].tan_half_height = 0.04f;
    return scene;
}

} // namespace

TEST_CASE("thin rods: photons of radii wider than a rod do not darken it", "[integrator]")
{
    ImageOptions options;
    options.width = options.height = 12;
    options.photons = GENERATE(10'000, 40'000);
    check_agreement(*tiny::ready(lit_rod()), options, 8, 100, {.most_noise = 0.02});
}
