#include "preprocess/summary.h"
#include "tests/support/tiny_meshes.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace hipmap;

namespace {

/// `count` triangles that do not touch, each larger than the one before.
Scene separate_triangles(std::uint32_t count)
{
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> corners;
    for (std::uint32_t i = 0; i < count; ++i) {
        const float side = 0.5f + 0.4f * static_cast<float>(i) / static_cast<float>(count);
        const glm::vec3 at(i % 64, 0, i / 64);
        positions.insert(positions.end(),
                         {at, at + glm::vec3(0, 0, side), at + glm::vec3(side, 0, 0)});
        corners.emplace_back(3 * i + glm::uvec3(0, 1, 2));
    }
    Scene scene = tiny::make_scene(tiny::make_mesh(positions, corners));
    scene.mesh.object_names = {"Confetti"};
    return scene;
}

nlohmann::json summary_of(std::uint32_t count)
{
    const Scene scene = separate_triangles(count);
    const PartitionResult result = build_partition(scene, {});
    return nlohmann::json::parse(summary_json({}, scene, result.partition, result.summary, {}));
}

} // namespace

TEST_CASE("summary: up to a thousand maps are all listed", "[preprocess]")
{
    const nlohmann::json json = summary_of(1000);
    CHECK(json["maps"].size() == 1000);
    CHECK(!json.contains("unlisted_maps"));
    CHECK(json["maps"][7]["objects"] == std::vector<std::string>{"Confetti"});
}

TEST_CASE("summary: of more maps the largest thousand are listed, and the rest are summed",
          "[preprocess]")
{
    const nlohmann::json json = summary_of(1200);
    CHECK(json["shared_maps"] == 1200);
    REQUIRE(json["maps"].size() == 1000);
    for (std::size_t i = 0; i < 1000; ++i)
        REQUIRE(json["maps"][i]["id"] == i + 200);
    CHECK(json["unlisted_maps"]["maps"] == 200);
    CHECK(json["unlisted_maps"]["faces"] == 200);
    double area = 0; // of triangles 0 to 199
    for (int i = 0; i < 200; ++i)
        area += 0.5 * std::pow(0.5 + 0.4 * i / 1200, 2);
    CHECK(json["unlisted_maps"]["area_m2"].get<double>() == Approx(area).epsilon(1e-5));
}
