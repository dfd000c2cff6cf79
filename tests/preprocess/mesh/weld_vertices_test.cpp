#include "preprocess/mesh/weld_vertices.h"
#include "tests/support/tiny_meshes.h"

#include <catch2/catch.hpp>

#include <map>
#include <tuple>

using namespace hipmap;

TEST_CASE("weld_vertices: a cube split at its seams has eight vertices", "[mesh]")
{
    const TriangleMesh cube = tiny::cube();
    REQUIRE(cube.positions.size() == 24);
    CHECK(weld_vertices(cube.positions).count == 8);
}

TEST_CASE("weld_vertices: zero and minus zero are one position", "[mesh]")
{
    const std::vector<glm::vec3> positions{{0, -0.0f, 1}, {-0.0f, 0, 1}, {0, 0, -1}};
    const VertexWeld weld = weld_vertices(positions);
    CHECK(weld.id_of_vertex == std::vector<std::uint32_t>{0, 0, 1});
}

TEST_CASE("weld_vertices: positions that differ in the last bit stay apart", "[mesh]")
{
    const std::vector<glm::vec3> positions{{1, 0, 0}, {std::nextafter(1.0f, 2.0f), 0, 0}};
    CHECK(weld_vertices(positions).count == 2);
}

TEST_CASE("weld_vertices: no vertices, no ids", "[mesh]")
{
    CHECK(weld_vertices({}).count == 0);
}

TEST_CASE("weld_vertices: ids are those of an ordered map, numbered by lowest vertex", "[mesh]")
{
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const TriangleMesh mesh = tiny::random_mesh(seed, 1 + seed, 1);
        const VertexWeld weld = weld_vertices(mesh.positions);
        std::map<std::tuple<float, float, float>, std::uint32_t> ids;
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            const glm::vec3& p = mesh.positions[v];
            const auto next = static_cast<std::uint32_t>(ids.size());
            REQUIRE(weld.id_of_vertex[v] == ids.try_emplace({p.x, p.y, p.z}, next).first->second);
        }
        REQUIRE(weld.count == ids.size());
    }
}

TEST_CASE("weld_vertices: the number of parts changes nothing", "[mesh]")
{
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        const TriangleMesh mesh = tiny::random_mesh(seed, 1 + 20 * seed, 1);
        const VertexWeld one = weld_vertices(mesh.positions, 0.0, 1);
        for (const std::size_t parts : {2, 3, 16}) {
            const VertexWeld many = weld_vertices(mesh.positions, 0.0, parts);
            REQUIRE(many.id_of_vertex == one.id_of_vertex);
            REQUIRE(many.count == one.count);
        }
    }
}

TEST_CASE("weld_vertices: by distance, kept positions are farther apart and the rest have the "
          "nearest of them",
          "[mesh]")
{
    for (const double distance : {1e-4, 0.03, 0.2, 5.0}) {
        RandomSequence random(3, RandomStream::pictures, 0, 0);
        std::vector<glm::vec3> positions;
        for (int i = 0; i < 600; ++i) {
            const glm::vec2 xy = random.next2();
            positions.emplace_back(xy - 0.5f, 0.3f * random.next());
        }
        const VertexWeld weld = weld_vertices(positions, distance);
        std::vector<glm::dvec3> kept; // by id, in the order in which ids appear
        for (std::size_t v = 0; v < positions.size(); ++v) {
            std::uint32_t nearest = kNone;
            double least = distance;
            for (std::uint32_t id = 0; id < kept.size(); ++id)
                if (const double d = glm::distance(kept[id], glm::dvec3(positions[v]));
                    d <= least) {
                    nearest = d < least || nearest == kNone ? id : nearest;
                    least = d;
                }
            if (nearest == kNone) {
                nearest = static_cast<std::uint32_t>(kept.size());
                kept.emplace_back(positions[v]);
            }
            REQUIRE(weld.id_of_vertex[v] == nearest);
        }
        REQUIRE(weld.count == kept.size());
    }
}
