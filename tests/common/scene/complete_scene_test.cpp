#include "common/input_error.h"
#include "common/scene/fingerprint.h"
#include "common/scene/print_audit.h"
#include "tests/common/scene/tiny_gltf_file.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

namespace hipmap::tiny {

namespace {

GltfFile emissive()
{
    GltfFile file = tetrahedron_file();
    file.root["materials"][0]["emissiveFactor"] = {1, 1, 1};
    return file;
}

GltfFile two_cameras()
{
    GltfFile file = tetrahedron_file();
    file.root["cameras"] = {
        {{"type", "perspective"}, {"perspective", {{"yfov", 0.8}, {"znear", 0.1}}}}};
    file.root["nodes"].push_back({{"name", "front"}, {"camera", 0}});
    file.root["nodes"].push_back({{"name", "top"}, {"camera", 0}});
    file.root["scenes"][0]["nodes"] = {0, 1, 2};
    return file;
}

} // namespace

TEST_CASE("without a camera one is supplied that sees every vertex", "[scene][camera]")
{
    for (const auto& scale :
         {json{1, 1, 1}, json{100, 0.01, 1}, json{1e-5, 1e-5, 1e5}, json{0, 0, 0}}) {
        GltfFile file = tetrahedron_file();
        file.root["nodes"][0]["scale"] = scale;
        const LoadedScene loaded = load(file);
        REQUIRE(loaded.scene.cameras.size() == 1);
        CHECK(says(loaded.audit.assumed, "no camera in the file"));
        const Camera& camera = loaded.scene.cameras[0];
        for (const glm::vec3& position : loaded.scene.mesh.positions) {
            const glm::vec3 to = position - camera.position;
            const float depth = glm::dot(to, camera.forward);
            CHECK(depth > 0);
            CHECK(std::abs(glm::dot(to, camera.up)) <= camera.tan_half_height * depth);
            CHECK(std::abs(glm::dot(to, camera.right)) <= camera.tan_half_height * depth);
        }
        CHECK(camera.forward.z < 0); // from the front,
        CHECK(camera.forward.y < 0); // slightly above
    }
}

TEST_CASE("of several cameras the named one is taken", "[scene][camera]")
{
    const LoadedScene first = load(two_cameras());
    CHECK(first.scene.camera == 0);
    CHECK(says(first.audit.found, "2 cameras: 'front' and 'top'; using 'front' (--camera"));
    SceneOptions options;
    options.camera = "top";
    CHECK(load(two_cameras(), options).scene.camera == 1);
    options.camera = "back";
    CHECK_THROWS_WITH(load(two_cameras(), options),
                      Catch::Contains("'back'") && Catch::Contains("'front' and 'top'"));
    CHECK_THROWS_WITH(load(tetrahedron_file(), options), Catch::Contains("no cameras"));
}

TEST_CASE("only a scene without light gets a grey sky", "[scene][lights]")
{
    const LoadedScene dark = load(tetrahedron_file());
    CHECK(dark.scene.environment == Rgb(1.0f));
    CHECK(says(dark.audit.assumed, "Punctual Lights"));
    CHECK(load(emissive()).scene.environment == Rgb(0.0f));

    GltfFile unworn = tetrahedron_file(); // an emissive material that no face wears lights nothing
    unworn.root["materials"].push_back({{"name", "bulb"}, {"emissiveFactor", {1, 1, 1}}});
    const LoadedScene unlit = load(unworn);
    CHECK(unlit.scene.environment == Rgb(1.0f));
    CHECK(says(unlit.audit.warnings, "emissive material 'bulb' is on no face"));
    CHECK(load(emissive()).audit.warnings.empty());

    SceneOptions options;
    options.environment = Rgb(0.0f, 0.5f, 2.0f);
    CHECK(load(emissive(), options).scene.environment == Rgb(0.0f, 0.5f, 2.0f));
    options.environment = Rgb(0.0f);
    CHECK(says(load(tetrahedron_file(), options).audit.warnings, "black"));
}

TEST_CASE("a light without power does not count as light", "[scene][lights]")
{
    GltfFile file = tetrahedron_file();
    file.root["extensions"] = {
        {"KHR_lights_punctual", {{"lights", {{{"type", "point"}, {"intensity", 0}}}}}}};
    file.root["nodes"][0]["extensions"] = {{"KHR_lights_punctual", {{"light", 0}}}};
    const LoadedScene loaded = load(file);
    CHECK(loaded.scene.environment == Rgb(1.0f));
    CHECK(says(loaded.audit.warnings, "light without power: 'thing'"));
}

TEST_CASE("excluded objects leave no trace in faces, vertices or the box", "[scene]")
{
    GltfFile file = emissive();
    file.root["nodes"].push_back({{"name", "cutter"}, {"mesh", 0}, {"translation", {100, 0, 0}}});
    file.root["scenes"][0]["nodes"] = {0, 1};
    SceneOptions options;
    options.exclude = {"cutter"};
    const LoadedScene left = load(file, options);
    const LoadedScene plain = load(emissive());
    CHECK(fingerprint(left.scene) == fingerprint(plain.scene));
    CHECK(left.scene.mesh.positions.size() == 4);
    CHECK(says(left.audit.found, "excluded: 'cutter', 4 faces"));

    options.exclude = {"tetrahedron"}; // the mesh that both share
    CHECK_THROWS_WITH(load(file, options), Catch::Contains("no faces"));
    options.exclude = {"cuter"};
    CHECK_THROWS_WITH(load(file, options),
                      Catch::Contains("--exclude 'cuter'") && Catch::Contains("'cutter'"));
}

TEST_CASE("transmissive and emissive materials are reported", "[scene]")
{
    GltfFile file = emissive();
    file.root["materials"][0]["extensions"] = {
        {"KHR_materials_transmission", {{"transmissionFactor", 1}}}};
    const LoadedScene loaded = load(file);
    CHECK(says(loaded.audit.assumed, "'paint': solid glass where its mesh is closed"));
    CHECK(says(loaded.audit.found, "emissive material 'paint' on 4 faces"));
    CHECK(says(loaded.audit.found, "4 faces in 1 object, 1 material"));
}

TEST_CASE("a fingerprint follows geometry and frame and nothing else", "[scene][fingerprint]")
{
    const Scene scene = load(tetrahedron_file()).scene;
    Scene other = scene;
    other.materials[0].base_color = Rgb(0.5f);
    other.cameras[0].position.x += 1;
    other.environment = Rgb(3.0f);
    other.mesh.object_names = {"renamed"};
    CHECK(fingerprint(other) == fingerprint(scene));

    other = scene;
    other.mesh.positions[2].y = std::nextafter(other.mesh.positions[2].y, 9.0f);
    CHECK_FALSE(fingerprint(other) == fingerprint(scene));
    other = scene;
    std::swap(other.mesh.corners[0], other.mesh.corners[1]);
    CHECK_FALSE(fingerprint(other) == fingerprint(scene));
    other = scene;
    other.frame.metres_per_unit *= 2;
    CHECK_FALSE(fingerprint(other) == fingerprint(scene));
    other = scene;
    other.mesh.corners.pop_back();
    CHECK_FALSE(fingerprint(other) == fingerprint(scene));
}

TEST_CASE("a fingerprint of the content follows what can be seen, not names",
          "[scene][fingerprint]")
{
    const Scene scene = load(tetrahedron_file()).scene;
    const std::vector<std::function<void(Scene&)>> seen = {
        [](Scene& s) { s.mesh.positions[2].y = std::nextafter(s.mesh.positions[2].y, 9.0f); },
        [](Scene& s) { s.mesh.normals.push_back(glm::vec3(1)); },
        [](Scene& s) { s.mesh.attributes.uv[1].emplace_back(); },
        [](Scene& s) { s.materials[0].base_color.y += 0.5f; },
        [](Scene& s) { s.materials[0].textures.emplace_back(); },
        [](Scene& s) { s.materials.emplace_back(); },
        [](Scene& s) { s.images.emplace_back(); },
        [](Scene& s) { s.lights.emplace_back(); },
        [](Scene& s) { s.lights.emplace_back(SceneAreaLight{}); },
        [](Scene& s) { s.environment.z += 1; },
        [](Scene& s) { s.cameras[0].position.x += 1; },
        [](Scene& s) { s.look = Look::blender_4; }};
    std::vector<Fingerprint> found = {content_fingerprint(scene)};
    for (const auto& change : seen) {
        Scene other = scene;
        change(other);
        found.push_back(content_fingerprint(other));
        CHECK(std::count(found.begin(), found.end(), found.back()) == 1);
    }
    Scene other = scene;
    other.mesh.object_names = {"renamed"};
    other.materials[0].name = other.cameras[0].name = "renamed";
    other.cameras.emplace_back(); // not the one rendered from
    CHECK(content_fingerprint(other) == found[0]);
}

TEST_CASE("printing an audit counts what is lost as warnings", "[scene]")
{
    Report report;
    print_audit(report, {{"4 faces"}, {"a camera"}, {"no texture", "no fog"}});
    CHECK(report.warnings() == 2);
}

} // namespace hipmap::tiny
