#include "preprocess/mesh/welded_faces.h"
#include "tests/support/tiny_meshes.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <map>

using namespace hipmap;

namespace {

WeldedFaces welded(std::uint64_t seed)
{
    const auto size = static_cast<std::uint32_t>(seed);
    const TriangleMesh mesh = tiny::random_mesh(seed, 3 + size, 2 * size);
    return weld_faces(mesh, weld_vertices(mesh.positions));
}

} // namespace

TEST_CASE("pair_edges: partners and the other edges are those of an ordered map", "[mesh]")
{
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        const WeldedFaces faces = welded(seed);
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> edges;
        for (std::uint32_t edge = 0; edge < faces.vertex_of_corner.size(); ++edge)
            if (faces.degenerate[edge / 3] == 0)
                edges[std::minmax({faces.start(edge), faces.end(edge)})].push_back(edge);
        const EdgePairs pairs = pair_edges(faces, 1);
        std::vector<std::uint32_t> partner(faces.vertex_of_corner.size(), kNone);
        EdgeGroups others;
        bool wound_alike = true;
        for (const auto& [ends, group] : edges) {
            if (group.size() == 2) {
                partner[group[0]] = group[1];
                partner[group[1]] = group[0];
                wound_alike = wound_alike && faces.start(group[0]) != faces.start(group[1]);
                continue;
            }
            others.edges.insert(others.edges.end(), group.begin(), group.end());
            others.first.push_back(static_cast<std::uint32_t>(others.edges.size()));
        }
        REQUIRE(pairs.partner == partner);
        REQUIRE(pairs.others.edges == others.edges);
        REQUIRE(pairs.others.first == others.first);
        REQUIRE(pairs.wound_alike == wound_alike);
    }
}

TEST_CASE("pair_edges: the number of parts changes nothing", "[mesh]")
{
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        const WeldedFaces faces = welded(seed);
        const EdgePairs one = pair_edges(faces, 1);
        for (const std::size_t parts : {2, 3, 16}) {
            const EdgePairs many = pair_edges(faces, parts);
            REQUIRE(many.partner == one.partner);
            REQUIRE(many.others.edges == one.others.edges);
            REQUIRE(many.others.first == one.others.first);
            REQUIRE(many.wound_alike == one.wound_alike);
        }
    }
}
