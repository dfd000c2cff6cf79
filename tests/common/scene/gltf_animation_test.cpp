#include "common/input_error.h"
#include "common/scene/gltf_animation.h"
#include "tests/common/scene/load_at.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

namespace hipmap::tiny {

namespace {

struct Keys {
    std::string path;
    std::vector<float> times, values;
    std::string interpolation = "LINEAR";
};

/// Adds an animation of one channel that drives a node.
void animate(GltfFile& file, int node, const Keys& keys)
{
    const bool turns = keys.path == "rotation";
    const int input = file.add_accessor(keys.times, "SCALAR", 1, 5126);
    const int output = file.add_accessor(keys.values, turns ? "VEC4" : "VEC3", turns ? 4 : 3, 5126);
    file.root["animations"].push_back(
        {{"name", "go " + keys.path},
         {"channels", {{{"sampler", 0}, {"target", {{"node", node}, {"path", keys.path}}}}}},
         {"samplers",
          {{{"input", input}, {"output", output}, {"interpolation", keys.interpolation}}}}});
}

/// Where a point of the mesh comes that the file has at (1, 0, 0).
glm::dvec3 tip_at(const GltfFile& file, double time)
{
    return world(load_at(file, time).scene, 2); // numbered by first use
}

} // namespace

TEST_CASE("a linear translation passes its keys and the middle, and stays at its ends", "[scene]")
{
    GltfFile file = tetrahedron_file();
    animate(file, 0, {"translation", {1, 3}, {0, 0, 0, 4, 2, -6}});
    check_near(tip_at(file, 0), {1, 0, 0});
    check_near(tip_at(file, 1), {1, 0, 0});
    check_near(tip_at(file, 1.5), {2, 0.5, -1.5});
    check_near(tip_at(file, 3), {5, 2, -6});
    check_near(tip_at(file, 9), {5, 2, -6});
}

TEST_CASE("a step holds each key until the next", "[scene]")
{
    GltfFile file = tetrahedron_file();
    animate(file, 0, {"translation", {0, 1, 2}, {0, 0, 0, 1, 0, 0, 7, 0, 0}, "STEP"});
    check_near(tip_at(file, 0.999), {1, 0, 0});
    check_near(tip_at(file, 1), {2, 0, 0});
    check_near(tip_at(file, 2), {8, 0, 0});
}

TEST_CASE("a linear rotation turns evenly, the short way whatever the quaternion's sign", "[scene]")
{
    const auto half = static_cast<float>(std::numbers::sqrt2 / 2);
    for (const float sign : {1.0f, -1.0f}) {
        GltfFile file = tetrahedron_file(); // a quarter turn about y
        animate(file, 0, {"rotation", {0, 1}, {0, 0, 0, 1, 0, sign * half, 0, sign * half}});
        for (const double part : {0.0, 0.25, 1.0 / 3, 1.0}) {
            const double angle = part * std::numbers::pi / 2;
            check_near(tip_at(file, part), {std::cos(angle), 0, -std::sin(angle)});
        }
    }
}

TEST_CASE("a cubic spline is Hermite's: s^2 by its tangents", "[scene]")
{
    GltfFile file = tetrahedron_file(); // x = t^2 / 2 over 2 s: slopes 0 and 2
    animate(file, 0,
            {"translation",
             {0, 2},
             {9, 9, 9, 0, 0, 0, 0, 0, 0, 2, 0, 0, 2, 0, 0, 9, 9, 9},
             "CUBICSPLINE"});
    for (const double t : {0.0, 0.5, 1.0, 1.7, 2.0})
        check_near(tip_at(file, t), {1 + t * t / 2, 0, 0});
}

TEST_CASE("what hangs on a node that moves comes along: meshes, lights, cameras", "[scene]")
{
    GltfFile file = tetrahedron_file();
    file.root["extensions"] = {
        {"KHR_lights_punctual", {{"lights", {{{"type", "point"}, {"intensity", 683}}}}}}};
    file.root["cameras"] = {
        {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.01}}}}};
    file.root["nodes"].push_back({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    file.root["nodes"].push_back({{"camera", 0}});
    file.root["nodes"].push_back({{"name", "cart"}, {"children", {0, 1, 2}}});
    file.root["scenes"][0]["nodes"] = {3};
    animate(file, 3, {"scale", {0, 2}, {1, 1, 1, 3, 3, 3}});
    animate(file, 3, {"translation", {0, 2}, {0, 0, 0, 8, 0, 0}});
    const Scene scene = load_at(file, 1).scene;
    const SceneFrame& frame = scene.frame;
    check_near(world(scene, 2), {4 + 2, 0, 0});
    check_near(frame.centre +
                   frame.metres_per_unit * std::get<ScenePointLight>(scene.lights.at(0)).position,
               {4, 0, 0});
    check_near(frame.centre + frame.metres_per_unit * glm::dvec3(scene.cameras.at(0).position),
               {4, 0, 0});
}

TEST_CASE("all frames have one frame of coordinates, so what stands still keeps its bits",
          "[scene]")
{
    GltfFile file = tetrahedron_file();
    file.root["nodes"].push_back({{"name", "runner"}, {"mesh", 0}});
    file.root["scenes"][0]["nodes"] = {0, 1};
    animate(file, 1, {"translation", {0, 1, 2}, {0, 0, 0, 40, 3, 0, 0, -9, 0}});
    const Scene first = load_at(file, 0).scene;
    REQUIRE(first.frame.metres_per_unit == 64.0); // 41 m are swept
    for (const double time : {0.3, 1.0, 2.0, 5.0}) {
        const Scene scene = load_at(file, time).scene;
        CHECK(scene.frame.centre == first.frame.centre);
        CHECK(scene.frame.metres_per_unit == first.frame.metres_per_unit);
        for (std::size_t i = 0; i < 4; ++i)
            CHECK(scene.mesh.positions[i] == first.mesh.positions[i]);
    }
}

TEST_CASE("an excluded object does not widen the frame", "[scene]")
{
    GltfFile file = tetrahedron_file();
    file.root["nodes"].push_back({{"name", "runner"}, {"mesh", 0}});
    file.root["scenes"][0]["nodes"] = {0, 1};
    animate(file, 1, {"translation", {0, 1}, {0, 0, 0, 40, 0, 0}});
    SceneOptions options;
    options.time = 0;
    options.exclude = {"runner"};
    CHECK(load(file, options).scene.frame.metres_per_unit == 1.0);
}

TEST_CASE("the audit says what moves, and that it is not asked for", "[scene]")
{
    GltfFile file = tetrahedron_file();
    animate(file, 0, {"translation", {0.5f, 1}, {0, 0, 0, 4, 0, 0}});
    CHECK(says(load(file).audit.assumed,
               "animation 'go translation' moves 'thing' from 0.5 to 1 s: showing the rest pose"));
    CHECK(says(load_at(file, 0.75).audit.found, "this frame is at 0.75 s"));
    CHECK(world(load(file).scene, 2).x == 1.0);
    CHECK(says(load_at(tetrahedron_file(), 1).audit.warnings, "the file has no animation"));

    animate(file, 0, {"translation", {0, 1}, {5, 5, 5, 5, 5, 5}});
    CHECK(says(load_at(file, 0).audit.assumed, "moves the same nodes as an earlier one"));
    check_near(tip_at(file, 0.5), {1, 0, 0});
}

TEST_CASE("damaged animations are refused by their place", "[scene]")
{
    GltfFile good = tetrahedron_file();
    animate(good, 0, {"translation", {0, 1, 2}, {0, 0, 0, 1, 0, 0, 2, 0, 0}});
    const auto refuses = [&](const char* pointer, const json& value, const char* naming) {
        GltfFile file = good;
        file.root[json::json_pointer(pointer)] = value;
        INFO(pointer);
        CHECK_THROWS_WITH(load(file), Catch::Contains(naming));
    };
    CHECK_NOTHROW(load(good));
    refuses("/animations/0/channels/0/sampler", 1, "samplers[1]");
    refuses("/animations/0/channels/0/target/node", 7, "node");
    refuses("/animations/0/channels/0/target/path", "rotation", "wrong type");
    refuses("/animations/0/samplers/0/input", 0, "not numbers");
    refuses("/animations/0/samplers/0/output", 99, "output");
    refuses("/animations/0/samplers/0/output", 0, "different number of values");
    refuses("/animations/0/samplers/0/interpolation", "CUBICSPLINE", "different number of values");
    refuses("/animations/0/samplers/0/interpolation", "SMOOTH", "interpolation");
    refuses("/nodes/0/matrix",
            json(std::vector<int>{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}), "nodes[0]");

    GltfFile falling = tetrahedron_file();
    animate(falling, 0, {"translation", {0, 2, 1}, {0, 0, 0, 1, 0, 0, 2, 0, 0}});
    CHECK_THROWS_WITH(load(falling), Catch::Contains("times that decrease"));
    GltfFile far = tetrahedron_file();
    animate(far, 0, {"translation", {0, 1}, {0, 0, 0, NAN, 0, 0}});
    CHECK_THROWS_WITH(load(far), Catch::Contains("not finite"));
}

} // namespace hipmap::tiny
