#include "preprocess/partition/build_partition.h"
#include "tests/support/hard_surfaces.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

/// A surface fine enough for groups, of size about 1.
TriangleMesh surface(std::uint64_t seed)
{
    TriangleMesh mesh = seed % 3 == 0   ? tiny::thin_shell(40, 0.05f)
                        : seed % 3 == 1 ? tiny::hairpin(14, 0.1f)
                                        : tiny::uv_sphere(32, 17);
    tiny::jitter(mesh, 0.002f, seed);
    tiny::transform(mesh, tiny::random_rotation(seed));
    return mesh;
}

template <typename Values>
bool begins_with(const Values& all, const Values& first)
{
    return std::equal(first.begin(), first.end(), all.begin());
}

} // namespace

TEST_CASE("trees_of_maps: what is known of a map does not depend on where others lie",
          "[partition]")
{
    int groups = 0;
    for (std::uint64_t seed = 0; seed < 24; ++seed) {
        const TriangleMesh mesh = surface(seed);
        TriangleMesh other = tiny::uv_sphere(9, 7);
        RandomSequence random(seed, RandomStream::pictures, 0, 3);
        tiny::transform(other, tiny::random_rotation(seed + 1), 0.2f,
                        0.3f * glm::vec3(random.next(), random.next(), random.next()));
        const Partition alone =
            build_partition(tiny::make_scene(mesh), {.angle_threshold = 2}).partition;
        const Partition both =
            build_partition(tiny::make_scene(tiny::together(mesh, other)), {.angle_threshold = 2})
                .partition;
        INFO("seed " << seed);
        REQUIRE(alone.position_error == both.position_error);
        CHECK(begins_with(both.kept_edges, alone.kept_edges));
        CHECK(begins_with(both.self_distance, alone.self_distance));
        CHECK(begins_with(both.group_of_face, alone.group_of_face));
        CHECK(begins_with(both.group_radius, alone.group_radius));
        groups += static_cast<int>(alone.group_count);
    }
    CHECK(groups > 24);
}
