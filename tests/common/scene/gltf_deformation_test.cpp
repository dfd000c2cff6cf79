#include "common/input_error.h"
#include "tests/common/scene/load_at.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace hipmap::tiny {

namespace {

struct DeformationKeys {
    int node = 0;
    std::string path;
    std::vector<float> times, values;
    std::string interpolation = "LINEAR";
};

void animate(GltfFile& file, const DeformationKeys& keys)
{
    const int input = file.add_accessor(keys.times, "SCALAR", 1, 5126);
    const bool weights = keys.path == "weights", turns = keys.path == "rotation";
    const int output = file.add_accessor(keys.values,
                                         weights ? "SCALAR"
                                         : turns ? "VEC4"
                                                 : "VEC3",
                                         weights ? 1
                                         : turns ? 4
                                                 : 3,
                                         5126);
    file.root["animations"].push_back(
        {{"channels", {{{"sampler", 0}, {"target", {{"node", keys.node}, {"path", keys.path}}}}}},
         {"samplers",
          {{{"input", input}, {"output", output}, {"interpolation", keys.interpolation}}}}});
}

/// The tetrahedron with two shape keys: one pushes its tip at (1, 0, 0) by 2 along x, the other the
/// tip at (0, 1, 0) by 1 along z.
GltfFile with_shape_keys()
{
    GltfFile file = tetrahedron_file();
    const int first = file.add_vectors({0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0});
    const int second = file.add_vectors({0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0});
    file.root["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", first}},
                                                          {{"POSITION", second}}};
    return file;
}

/// The tetrahedron on two joints, nodes 1 and 2 under node 3, bound at (5, 0, 0) and (5, 1, 0): the
/// first holds the foot, the second, which stands at (7, 1, 0), the tips.
GltfFile with_skin()
{
    GltfFile file = tetrahedron_file();
    json& attributes = file.root["meshes"][0]["primitives"][0]["attributes"];
    attributes["JOINTS_0"] = file.add_accessor(
        std::vector<std::uint8_t>{0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4", 4, 5121);
    attributes["WEIGHTS_0"] =
        file.add_accessor(std::vector<float>{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0},
                          "VEC4", 4, 5126); // the last is not normalised
    const int bind =
        file.add_accessor(std::vector<float>{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -5, 0,  0, 1, //
                                             1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -5, -1, 0, 1},
                          "MAT4", 16, 5126);
    file.root["skins"] = {{{"joints", {1, 2}}, {"inverseBindMatrices", bind}}};
    file.root["nodes"][0]["skin"] = 0;
    file.root["nodes"][0]["translation"] = {100, 0, 0}; // ignored by glTF 2.0
    file.root["nodes"].push_back({{"name", "foot"}, {"translation", {5, 0, 0}}});
    file.root["nodes"].push_back({{"name", "tips"}, {"translation", {7, 1, 0}}});
    file.root["nodes"].push_back({{"name", "rig"}, {"children", {0, 1, 2}}});
    file.root["scenes"][0]["nodes"] = {3};
    return file;
}

/// Where the vertices come that the file has at the origin and at (1, 0, 0) and (0, 1, 0).
struct Corners {
    glm::dvec3 foot, x, y;
};

Corners corners_of(const Scene& scene)
{
    return {world(scene, 0), world(scene, 2), world(scene, 1)}; // numbered by first use
}

} // namespace

TEST_CASE("shape keys: a mesh is displaced by its weights, which its node overrides", "[scene]")
{
    GltfFile file = with_shape_keys();
    check_near(corners_of(load(file).scene).x, {1, 0, 0});
    file.root["meshes"][0]["weights"] = {0.5, 1};
    check_near(corners_of(load(file).scene).x, {2, 0, 0});
    check_near(corners_of(load(file).scene).y, {0, 1, 1});
    file.root["nodes"][0]["weights"] = {0, 0.25};
    file.root["nodes"][0]["translation"] = {3, 0, 0};
    check_near(corners_of(load(file).scene).x, {4, 0, 0});
    check_near(corners_of(load(file).scene).y, {3, 1, 0.25});
    CHECK_FALSE(says(load(file).audit.warnings, "shape keys"));
}

TEST_CASE("shape keys: normals move too", "[scene]")
{
    GltfFile file = with_shape_keys();
    json& primitive = file.root["meshes"][0]["primitives"][0];
    primitive["attributes"]["NORMAL"] = file.add_vectors({1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0});
    primitive["targets"][0]["NORMAL"] = file.add_vectors({0, 0, 0, -1, 1, 0, 0, 0, 0, 0, 0, 0});
    file.root["meshes"][0]["weights"] = {1, 0};
    check_near(load(file).scene.mesh.normals[2], {0, 1, 0});
    check_near(load(file).scene.mesh.normals[1], {1, 0, 0});
}

TEST_CASE("shape keys: --frames plays them, every interpolation", "[scene]")
{
    GltfFile file = with_shape_keys();
    animate(file, {.path = "weights", .times = {0, 1}, .values = {0, 1, 1, 0}});
    check_near(corners_of(load_at(file, 0.25).scene).x, {1.5, 0, 0});
    check_near(corners_of(load_at(file, 0.25).scene).y, {0, 1, 0.75});
    GltfFile stepped = with_shape_keys();
    animate(stepped,
            {.path = "weights", .times = {0, 1}, .values = {0, 1, 1, 0}, .interpolation = "STEP"});
    check_near(corners_of(load_at(stepped, 0.9).scene).x, {1, 0, 0});
    GltfFile cubic = with_shape_keys(); // the first weight is t^2: slopes 0 and 2
    animate(cubic, {.path = "weights",
                    .times = {0, 1},
                    .values = {9, 9, 0, 0, 0, 0, 2, 0, 1, 0, 9, 9},
                    .interpolation = "CUBICSPLINE"});
    check_near(corners_of(load_at(cubic, 0.5).scene).x, {1.5, 0, 0});
}

TEST_CASE("skins: joints alone place a mesh, not its node", "[scene]")
{
    const Corners at = corners_of(load(with_skin()).scene);
    check_near(at.foot, {0, 0, 0});
    check_near(at.x, {3, 0, 0}); // moved by 2 with its joint
    check_near(at.y, {2, 1, 0});
    CHECK(says(load(with_skin()).audit.found, "armature (skin) of 'thing'"));
}

TEST_CASE("skins: vertices blend the joints they follow, and normals turn", "[scene]")
{
    GltfFile file = with_skin();
    json& attributes = file.root["meshes"][0]["primitives"][0]["attributes"];
    attributes["NORMAL"] = file.add_vectors({1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0});
    attributes["JOINTS_0"] = file.add_accessor(
        std::vector<std::uint8_t>{0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4", 4, 5121);
    attributes["WEIGHTS_0"] =
        file.add_accessor(std::vector<float>{1, 0, 0, 0, 1, 3, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0},
                          "VEC4", 4, 5126); // a quarter and three quarters
    check_near(corners_of(load(file).scene).x, {2.5, 0, 0});
    file.root["nodes"][2]["rotation"] = {0, 0, 1, 0}; // half a turn about z
    check_near(load(file).scene.mesh.normals[1], {-1, 0, 0});
    check_near(corners_of(load(file).scene).y, {7 - 0 + 5, 1, 0});
}

TEST_CASE("skins: --frames plays joints, and the frame holds all poses", "[scene]")
{
    GltfFile file = with_skin();
    animate(file,
            {.node = 2, .path = "translation", .times = {0, 1}, .values = {5, 1, 0, 5, 9, 0}});
    const Scene begin = load_at(file, 0).scene, end = load_at(file, 1).scene;
    check_near(corners_of(begin).y, {0, 1, 0});
    check_near(corners_of(end).y, {0, 9, 0});
    CHECK(begin.frame.centre == end.frame.centre);
    CHECK(begin.frame.metres_per_unit == end.frame.metres_per_unit);
    for (const Scene& scene : {begin, end})
        for (const glm::vec3& p : scene.mesh.positions)
            CHECK(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= 0.5f + 1e-6f);
}

TEST_CASE("skins: mirrored joints keep the fronts of faces", "[scene]")
{
    const auto volume_of = [](const Scene& scene) {
        double sum = 0;
        for (const glm::uvec3& face : scene.mesh.corners)
            sum += glm::dot(world(scene, face.x),
                            glm::cross(world(scene, face.y), world(scene, face.z)));
        return sum / 6;
    };
    GltfFile file = with_skin();
    CHECK(volume_of(load(file).scene) > 0);
    file.root["nodes"][2]["translation"] = {5, 1, 0}; // as bound
    for (const int joint : {1, 2})
        file.root["nodes"][static_cast<std::size_t>(joint)]["scale"] = {-1, 1, 1};
    CHECK(volume_of(load(file).scene) > 0);
}

TEST_CASE("skins and shape keys: damaged files are refused with their place", "[scene]")
{
    GltfFile few = with_skin();
    few.root["skins"][0]["joints"] = {1};
    CHECK_THROWS_WITH(load(few), Catch::Contains("'thing': follows joint 1 of 1"));
    GltfFile odd = with_skin();
    odd.root["skins"][0]["inverseBindMatrices"] = 0;
    CHECK_THROWS_WITH(load(odd), Catch::Contains("skins[0].inverseBindMatrices"));
    GltfFile lost = with_skin();
    lost.root["scenes"][0]["nodes"] = {0};
    lost.root["nodes"][3].erase("children");
    CHECK(says(load(lost).audit.warnings, "skin of 'thing' is ignored"));
    GltfFile none = with_skin();
    none.root["skins"][0].erase("joints");
    CHECK_THROWS_AS(load(none), InputError);
    GltfFile shape = with_shape_keys();
    shape.root["meshes"][0]["primitives"][0]["targets"][0]["POSITION"] =
        shape.add_vectors({0, 0, 0});
    CHECK_THROWS_WITH(load(shape), Catch::Contains("targets[0].POSITION"));
    GltfFile keys = with_shape_keys();
    animate(keys, {.path = "weights", .times = {0, 1}, .values = {0, 1, 1}});
    CHECK_THROWS_WITH(load(keys), Catch::Contains("morph targets"));
}

TEST_CASE("shape keys: targets that share an accessor do not fill the memory", "[scene]")
{
    GltfFile file = with_shape_keys();
    json& targets = file.root["meshes"][0]["primitives"][0]["targets"];
    for (int i = 0; i < 2000; ++i)
        targets.push_back(targets[0]);
    CHECK_THROWS_WITH(load(file), Catch::Contains("more vertices than the file has data for"));
}

} // namespace hipmap::tiny
