#include "common/math/random.h"
#include "preprocess/partition/contact_face.h"
#include "tests/support/tiny_meshes.h"

#include <catch2/catch.hpp>

using namespace hipmap;

TEST_CASE("crossing: ends where edges of either face go through the other", "[partition]")
{
    int found = 0;
    for (std::uint64_t seed = 0; seed < 5000; ++seed) {
        RandomSequence random(seed, RandomStream::pictures, 0, 0);
        std::vector<glm::vec3> corners;
        for (int i = 0; i < 6; ++i) {
            const glm::vec2 xy = random.next2();
            corners.emplace_back(xy, random.next());
        }
        const TriangleMesh mesh = tiny::make_mesh(corners, {{0, 1, 2}, {3, 4, 5}});
        const ContactFace f(mesh, 0, 1e-7), g(mesh, 1, 1e-7);
        std::vector<glm::dvec3> pierced;
        for (const auto& [through, other] : {std::pair(&f, &g), std::pair(&g, &f)})
            for (int c = 0; c < 3; ++c) {
                const glm::dvec3& a = other->corners[c];
                const glm::dvec3& b = other->corners[(c + 1) % 3];
                const double h_a = through->height(a), h_b = through->height(b);
                const glm::dvec3 x = a + h_a / (h_a - h_b) * (b - a);
                if ((h_a < 0) != (h_b < 0) &&
                    std::ranges::all_of(through->planes, [&](const EdgePlane& plane) {
                        return plane.height(x) >= 0;
                    }))
                    pierced.push_back(x);
            }
        const auto line = crossing(f, g);
        if (pierced.size() != 2 || glm::distance(pierced[0], pierced[1]) < 1e-4) {
            REQUIRE((!line || glm::distance(line->a, line->b) < 2e-4));
            continue;
        }
        REQUIRE(line);
        ++found;
        const double same = glm::distance(line->a, pierced[0]) + glm::distance(line->b, pierced[1]);
        const double turned =
            glm::distance(line->a, pierced[1]) + glm::distance(line->b, pierced[0]);
        REQUIRE(std::min(same, turned) < 1e-9);
    }
    CHECK(found > 500);
}
