#include "preprocess/colouring/map_colours.h"
#include "preprocess/partition/build_partition.h"
#include "tests/support/tiny_meshes.h"

#include <catch2/catch.hpp>

using namespace hipmap;

TEST_CASE("map_colours: maps that meet at an edge are never alike", "[colouring]")
{
    std::vector<TriangleMesh> meshes{tiny::cube(), tiny::tetrahedron(), tiny::uv_sphere(40, 30),
                                     tiny::fan(100)};
    for (std::uint64_t seed = 0; seed < 100; ++seed)
        meshes.push_back(tiny::random_mesh(seed, 30, 40));
    for (const TriangleMesh& mesh : meshes) {
        // At threshold 0 every face is a map.
        const Partition p =
            build_partition(tiny::make_scene(mesh), {.angle_threshold = 0}).partition;
        const std::vector<Rgb> colours = map_colours(p);
        REQUIRE(colours.size() == p.map_count);
        for (std::uint32_t edge = 0; edge < p.opposite.size(); ++edge) {
            if (p.opposite[edge] == kNone)
                continue;
            const Rgb& mine = colours[p.map_of_face[edge / 3]];
            const Rgb& other = colours[p.map_of_face[p.opposite[edge] / 3]];
            REQUIRE(glm::length(mine - other) > 0.03f);
        }
    }
}

TEST_CASE("group_colours: groups that meet at an edge are never alike", "[colouring]")
{
    const TriangleMesh mesh = tiny::uv_sphere(60, 40);
    const Partition p = build_partition(tiny::make_scene(mesh), {}).partition;
    const std::vector<Rgb> colours = group_colours(p);
    REQUIRE(colours.size() == p.group_count);
    int rims = 0;
    for (std::uint32_t edge = 0; edge < p.opposite.size(); ++edge) {
        const std::uint32_t mine = p.group_of_face[edge / 3];
        const std::uint32_t other = p.group_of_face[p.opposite[edge] / 3];
        if (mine == other || mine == kNone || other == kNone)
            continue;
        ++rims;
        REQUIRE(glm::length(colours[mine] - colours[other]) > 0.03f);
    }
    CHECK(rims > 100);
}

TEST_CASE("palette_colour: the distinct colours are, and all can be shown", "[colouring]")
{
    for (std::uint32_t i = 0; i < 200; ++i) {
        const Rgb a = palette_colour(i);
        REQUIRE(std::min({a.x, a.y, a.z}) >= 0);
        REQUIRE(max_channel(a) <= 1);
        for (std::uint32_t j = 0; j < i; ++j)
            REQUIRE(glm::length(a - palette_colour(j)) > (i < kDistinctColours ? 0.03f : 0.0f));
    }
}
