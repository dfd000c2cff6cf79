#include "tests/preprocess/partition/posed_partition.h"

using namespace hipmap;
using tiny::in_all_poses;
using tiny::total_length;

namespace {

/// A sheet of width 1 along a curve.
TriangleMesh sheet_along(const std::vector<glm::vec2>& curve)
{
    const auto columns = static_cast<std::uint32_t>(curve.size() - 1);
    return tiny::bent_grid(columns, 3, [&](glm::vec2 p) {
        const float i = std::round(p.x * static_cast<float>(columns));
        return glm::vec3(curve[static_cast<std::size_t>(i)], p.y);
    });
}

/// Appends an arc in 12 steps; angles in degrees.
void append_arc(std::vector<glm::vec2>& curve, const glm::vec2& centre, float radius, float from,
                float to)
{
    for (int i = 1; i <= 12; ++i) {
        const float angle = glm::radians(from + (to - from) * static_cast<float>(i) / 12);
        curve.push_back(centre + radius * glm::vec2(std::cos(angle), std::sin(angle)));
    }
}

/// From (0, 0) along y = 0, up round x = 3, back over itself, and down to (1, 1).
std::vector<glm::vec2> curl()
{
    std::vector<glm::vec2> curve{{0, 0}, {1.7f, 0}, {3, 0}};
    append_arc(curve, {3, 1}, 1, -90, 90);
    append_arc(curve, {2, 1}, 1, 90, 180);
    return curve;
}

TriangleMesh torus(std::uint32_t n)
{
    const auto angle = [n](float x) {
        const auto i = static_cast<std::uint32_t>(std::round(x * static_cast<float>(n))) % n;
        return glm::two_pi<float>() * static_cast<float>(i) / static_cast<float>(n);
    };
    return tiny::bent_grid(n, n, [&](glm::vec2 p) {
        const float u = angle(p.x), v = angle(p.y), r = 1 + 0.4f * std::cos(v);
        return glm::vec3(r * std::cos(u), r * std::sin(u), 0.4f * std::sin(v));
    });
}

} // namespace

TEST_CASE("contacts: a sheet that cuts itself is bounded once along the cut", "[partition]")
{
    std::vector<glm::vec2> curve = curl();
    curve.emplace_back(1, -0.5f);
    in_all_poses(sheet_along(curve), [](const Partition& p, double s) {
        REQUIRE(p.map_count == 1);
        REQUIRE(total_length(p, 0) == Approx(s).epsilon(1e-3));
    });
}

TEST_CASE("contacts: a curled sheet that rests on itself is bounded where it does", "[partition]")
{
    std::vector<glm::vec2> curve = curl();
    curve.emplace_back(1, 0.5f);
    append_arc(curve, {0.5f, 0.5f}, 0.5f, 0, -180);
    in_all_poses(sheet_along(curve), [](const Partition& p, double s) {
        REQUIRE(p.map_count == 1);
        REQUIRE(total_length(p, 0) == Approx(s).epsilon(1e-3));
    });
}

TEST_CASE("contacts: a curled sheet that stands on itself is bounded by its own border",
          "[partition]")
{
    std::vector<glm::vec2> curve = curl();
    curve.emplace_back(1, 0);
    in_all_poses(sheet_along(curve), [](const Partition& p, double) {
        REQUIRE(p.map_count == 1);
        REQUIRE(p.contacts.empty()); // one would be where the border is
    });
}

TEST_CASE("contacts: a smooth sheet that does not meet itself has none", "[partition]")
{
    for (const TriangleMesh& mesh :
         {torus(30), sheet_along(curl()), tiny::bent_grid(40, 40, [](glm::vec2 p) {
              return glm::vec3(p, 0.1f * std::sin(9 * p.x) * std::sin(7 * p.y));
          })})
        in_all_poses(mesh, [](const Partition& p, double) {
            REQUIRE(p.map_count == 1);
            REQUIRE(p.contacts.empty());
        });
}
