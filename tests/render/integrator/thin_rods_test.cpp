#include "tests/support/means_of_images.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

/// A room whose only lamp looks up, and a smooth thing below it that fills the picture.
Scene lit_from_above(const TriangleMesh& thing)
{
    Scene scene = tiny::box(tiny::diffuse({0.7f, 0.6f, 0.5f}));
    tiny::add(scene, tiny::floor_at(0.3f, 0.4f), tiny::emissive(Rgb(8)));
    tiny::add(scene, thing, tiny::diffuse({0.5f, 0.6f, 0.7f}));
    scene.cameras[0].tan_half_height = 0.04f;
    return scene;
}

/// Twenty times as long as wide.
TriangleMesh rod()
{
    TriangleMesh mesh = tiny::uv_sphere(64, 32);
    for (glm::vec3& position : mesh.positions)
        position = glm::vec3(0.4f, 0.02f, 0.02f) * glm::vec3(position.y, position.z, position.x);
    return mesh;
}

/// A ring a tenth as thick as it is wide, so near that only a part of it is in the picture.
TriangleMesh ring()
{
    TriangleMesh mesh = tiny::torus(96, 24, 0.1f);
    for (glm::vec3& position : mesh.positions)
        position = 0.3f * glm::vec3(position.x, position.z, position.y) + glm::vec3(0, 0, -0.3f);
    return mesh;
}

} // namespace

TEST_CASE("thin things: photons of radii wider than a rod or a ring do not darken it",
          "[integrator]")
{
    const bool is_rod = GENERATE(true, false);
    ImageOptions options;
    options.width = options.height = 12;
    options.photons = GENERATE(10'000, 20'000);
    INFO((is_rod ? "rod, " : "ring, ") << options.photons << " light paths");
    check_agreement(*tiny::ready(lit_from_above(is_rod ? rod() : ring())), options, 16, 60,
                    {.most_noise = 0.02});
}
