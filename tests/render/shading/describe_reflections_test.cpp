#include "render/shading/describe_reflections.h"
#include "tests/support/tiny_scenes.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

Material named(Material material, const char* name, float roughness)
{
    material.name = name;
    material.roughness = roughness;
    return material;
}

} // namespace

TEST_CASE("describe reflections: materials that exist are named by what becomes of them",
          "[shading]")
{
    Scene scene = tiny::make_scene(tiny::floor_at(0, 1));
    scene.materials[0] = named(tiny::matt(Rgb(0.5f)), "matt", 1);
    CHECK(describe_reflections(scene).empty());
    tiny::add(scene, tiny::floor_at(0.1f, 1), named(tiny::mirror(Rgb(0.9f)), "mirror", 0));
    CHECK(describe_reflections(scene).empty());
    scene.materials.push_back(named(tiny::mirror(Rgb(0.9f)), "of no face", 0.5f));
    CHECK(describe_reflections(scene).empty());

    tiny::add(scene, tiny::floor_at(0.2f, 1), named(tiny::mirror(Rgb(0.9f)), "steel", 0.2f));
    tiny::add(scene, tiny::floor_at(0.3f, 1), named(tiny::glass(1.5f), "frosted", 0.6f));
    tiny::add(scene, tiny::floor_at(0.4f, 1), named(tiny::mirror(Rgb(0.9f)), "tin", 0.5f));
    const std::vector<std::string> sentences = describe_reflections(scene);
    REQUIRE(sentences.size() == 2);
    CHECK(sentences[0] == "glossy reflections up to roughness 0.3 and rough glass are followed by "
                          "rays: 'steel', 'frosted'");
    CHECK(sentences[1] == "reflections above roughness 0.3 are gathered from photons: 'tin'");
}
