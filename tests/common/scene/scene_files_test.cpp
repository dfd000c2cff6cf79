#include "common/input_error.h"
#include "tests/common/scene/tiny_gltf_file.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <fstream>
#include <optional>

namespace hipmap::tiny {

namespace {

/// The folder of scenes that may lie beside the checkout; the tests pass by where it does not.
std::filesystem::path scenes()
{
    return std::filesystem::path(HIPMAP_SOURCE_DIR) / ".." / "shared" / "scenes";
}

struct Outcome {
    std::optional<LoadedScene> loaded;
    std::string refusal;
};

Outcome try_load(const std::filesystem::path& path, const SceneOptions& options = {})
{
    try {
        return {load_scene(path, options), ""};
    } catch (const InputError& error) {
        return {std::nullopt, error.what()};
    }
}

/// Indices in range, numbers finite, normals unit or zero, arrays of one length.
void check_sound(const Scene& scene)
{
    const TriangleMesh& mesh = scene.mesh;
    REQUIRE(mesh.face_count() > 0);
    REQUIRE(mesh.material_of_face.size() == mesh.face_count());
    REQUIRE(mesh.object_of_face.size() == mesh.face_count());
    REQUIRE(mesh.normals.size() == mesh.positions.size());
    const VertexAttributes& attributes = mesh.attributes;
    for (const std::size_t size : {attributes.uv[0].size(), attributes.uv[1].size(),
                                   attributes.colours.size(), attributes.tangents.size()})
        REQUIRE((size == 0 || size == mesh.positions.size()));
    REQUIRE(scene.camera < scene.cameras.size());
    bool sound = true;
    for (FaceId face = 0; face < mesh.face_count(); ++face) {
        const glm::uvec3 c = mesh.corners[face];
        sound = sound && c.x < mesh.positions.size() && c.y < mesh.positions.size() &&
                c.z < mesh.positions.size() &&
                mesh.material_of_face[face] < scene.materials.size() &&
                mesh.object_of_face[face] < mesh.object_names.size();
    }
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const float length = glm::length(mesh.normals[i]);
        sound = sound && is_finite(mesh.positions[i]) && is_finite(mesh.normals[i]) &&
                (length == 0 || std::abs(length - 1) < 1e-5f);
    }
    CHECK(sound);
}

/// World positions of the middles of all faces, sorted, as files list them in any order.
std::vector<glm::dvec3> face_centres(const std::filesystem::path& path)
{
    const Scene scene = load_scene(path, {}).scene;
    std::vector<glm::dvec3> centres;
    for (const glm::uvec3& face : scene.mesh.corners)
        centres.push_back((world(scene, face.x) + world(scene, face.y) + world(scene, face.z)) /
                          3.0);
    std::sort(centres.begin(), centres.end(),
              [](const glm::dvec3& a, const glm::dvec3& b) { return a.x < b.x; });
    return centres;
}

/// Each of `some` has one of `others`, both sorted along x, within `error` metres.
void check_near(const std::vector<glm::dvec3>& some, const std::vector<glm::dvec3>& others,
                double error)
{
    std::size_t lonely = 0, first = 0;
    for (const glm::dvec3& p : some) {
        while (first < others.size() && others[first].x < p.x - error)
            ++first;
        bool found = false;
        for (std::size_t i = first; i < others.size() && others[i].x < p.x + error; ++i)
            found = found || glm::length(others[i] - p) < error;
        lonely += found ? 0 : 1;
    }
    CHECK(lonely == 0);
}

} // namespace

TEST_CASE("nasty scenes load where they are legal and are refused where they are not",
          "[scene][files]")
{
    const std::filesystem::path folder = scenes() / "hard";
    if (!std::filesystem::exists(folder / "manifest.json")) {
        WARN("no folder of nasty scenes beside the checkout; skipped");
        return;
    }
    std::ifstream stream(folder / "manifest.json");
    const json manifest = json::parse(stream);
    for (const json& entry : manifest["files"]) {
        const std::string file = entry["file"];
        INFO(file);
        const Outcome outcome = try_load(folder / file);
        CHECK(outcome.loaded.has_value() == outcome.refusal.empty());
        if (outcome.loaded)
            check_sound(outcome.loaded->scene);
        else
            CHECK(outcome.refusal.find('\n') == std::string::npos);
        if (entry["legal"].is_null())
            continue;
        // Some legal files hold nothing to do, and say so.
        const bool empty = entry["expect"].get<std::string>().starts_with("clear message");
        CHECK(outcome.loaded.has_value() == (entry["legal"].get<bool>() && !empty));
        const json triangles = entry.value("/facts/triangles"_json_pointer, json());
        if (outcome.loaded && !triangles.is_null())
            CHECK(outcome.loaded->scene.mesh.face_count() == triangles.get<std::size_t>());
    }
}

TEST_CASE("third-party models load, and compressed ones equal their plain form", "[scene][files]")
{
    const std::filesystem::path folder = scenes() / "real";
    if (!std::filesystem::exists(folder)) {
        WARN("no folder of models beside the checkout; skipped");
        return;
    }
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        const std::string suffix = entry.path().extension().string();
        if (suffix != ".glb" && suffix != ".gltf" && suffix != ".obj")
            continue;
        INFO(entry.path());
        const Outcome outcome = try_load(entry.path());
        CHECK(outcome.refusal.empty());
        if (outcome.loaded)
            check_sound(outcome.loaded->scene);
    }
    const auto faces = [&](const char* file) {
        return load_scene(folder / file, {}).scene.mesh.all_face_count();
    };
    CHECK(faces("spot/spot.obj") == 5856);
    CHECK(faces("compressed/spot_plain.glb") == 5856);
    CHECK(faces("gpu_instancing/24_gpu_instancing.gltf") == 2 + (958 + 941) * 12096 / 3);
    CHECK(faces("box_draco/BoxDraco.gltf") == 12);
    CHECK(faces("box_meshopt/BoxMeshopt.glb") == 12);
    const std::vector<glm::dvec3> plain = face_centres(folder / "compressed/spot_plain.glb");
    for (const char* packed : {"quantized", "draco", "meshopt"}) {
        INFO(packed);
        const std::string name = std::string("compressed/spot_") + packed + ".glb";
        CHECK(faces(name.c_str()) == 5856);
        check_near(face_centres(folder / name), plain, 1e-3);
    }
    CHECK(faces("cornell_box_obj/cornell_box.obj") == 34);
}

TEST_CASE("stock Blender exports load with their lights in one unit", "[scene][files]")
{
    const std::filesystem::path folder = scenes() / "blender";
    if (!std::filesystem::exists(folder)) {
        WARN("no folder of Blender exports beside the checkout; skipped");
        return;
    }
    const auto load_blender = [&](const char* file, LightUnits units = LightUnits::spec) {
        SceneOptions options;
        options.light_units = units;
        LoadedScene loaded = load_scene(folder / file, options);
        check_sound(loaded.scene);
        return loaded;
    };
    const LoadedScene cornell = load_blender("cornell.glb");
    CHECK(cornell.scene.mesh.face_count() == 4428);
    CHECK(cornell.audit.warnings.empty());
    CHECK(cornell.scene.environment == Rgb(0.0f));
    CHECK(load_blender("cornell_separate/cornell.gltf").scene.mesh.positions ==
          cornell.scene.mesh.positions);

    const auto point_of = [](const Scene& scene) {
        return std::get<ScenePointLight>(scene.lights.at(0));
    };
    const ScenePointLight standard = point_of(load_blender("cornell_point_standard.glb").scene);
    for (const auto& [file, units] : {std::pair{"cornell_point_unitless.glb", LightUnits::compat},
                                      std::pair{"cornell_point_raw.glb", LightUnits::raw}}) {
        const ScenePointLight light = point_of(load_blender(file, units).scene);
        CHECK(glm::length(light.intensity - standard.intensity) <
              1e-5f * glm::length(standard.intensity));
    }
    CHECK(load_blender("egg_chair.glb").scene.mesh.face_count() == 3018);
    CHECK(load_blender("instances.glb").scene.cameras.size() == 5);
    CHECK(load_blender("interior.glb").scene.images.size() == 1);
    CHECK(load_blender("area_light.glb").scene.lights.size() == 1);
}

} // namespace hipmap::tiny
