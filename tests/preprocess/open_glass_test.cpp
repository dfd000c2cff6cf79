#include "preprocess/open_glass.h"
#include "preprocess/partition/build_partition.h"
#include "tests/support/tiny_meshes.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

std::vector<std::string> sentences_of(const TriangleMesh& mesh, float transmission = 1)
{
    Scene scene = tiny::make_scene(mesh);
    scene.mesh.object_names = {"Vase"};
    for (Material& material : scene.materials)
        material.transmission = transmission;
    return describe_open_glass(scene, build_partition(scene, {}).partition);
}

} // namespace

TEST_CASE("open glass is named with its border edges", "[preprocess]")
{
    CHECK(
        sentences_of(tiny::open_box()) ==
        std::vector<std::string>{"'Vase' is open (4 border edges): rendered as a thin pane; close "
                                 "its mesh for solid glass"});
    CHECK(sentences_of(tiny::cube()).empty());
    CHECK(sentences_of(tiny::open_box(), 0).empty());
    REQUIRE(sentences_of(tiny::doubled()).size() == 1);
}
