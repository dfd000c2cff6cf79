#include "common/input_error.h"
#include "common/math/random.h"
#include "common/scene/triangulate.h"
#include "tests/common/scene/tiny_gltf_file.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

namespace hipmap::tiny {

namespace {

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

LoadedScene load_obj(const std::string& text)
{
    return load_text("scene.obj", text);
}

/// The one material of an OBJ file with this MTL file beside it.
LoadedScene load_with_mtl(const std::string& mtl)
{
    const TemporaryFolder folder;
    write_text(folder / "my paints.mtl", "newmtl m\n" + mtl);
    write_text(folder / "scene.obj", "mtllib my paints.mtl\n" + kSquare + "usemtl m \nf 1 2 3 4\n");
    return load_scene(folder / "scene.obj", {});
}

Material only_material(const std::string& mtl)
{
    const LoadedScene loaded = load_with_mtl(mtl);
    REQUIRE(loaded.scene.materials.size() == 1);
    return loaded.scene.materials[0];
}

/// Twice the sum of the triangles' signed areas, and of their absolute areas.
std::pair<double, double> doubled_areas(const std::vector<glm::dvec3>& points)
{
    double sum = 0, absolute = 0;
    for (const glm::uvec3& t : triangulate(points)) {
        const glm::dvec3 cross = glm::cross(points[t.y] - points[t.x], points[t.z] - points[t.x]);
        sum += cross.z;
        absolute += glm::length(cross);
    }
    return {sum, absolute};
}

} // namespace

TEST_CASE("triangulating a simple polygon covers it once", "[scene][obj]")
{
    RandomSequence random(5, RandomStream::pictures, 0, 0);
    for (int round = 0; round < 200; ++round) {
        // Star-shaped about the origin, so simple, and concave nearly always; tilted.
        const int n = 3 + static_cast<int>(random.next() * 40);
        std::vector<glm::dvec3> points;
        double shoelace = 0.0;
        for (int i = 0; i < n; ++i) {
            const double angle = 2 * std::numbers::pi * i / n;
            const double radius = 0.1 + random.next();
            points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
        }
        for (int i = 0; i < n; ++i) {
            const glm::dvec3 &a = points[static_cast<std::size_t>(i)],
                             &b = points[static_cast<std::size_t>((i + 1) % n)];
            shoelace += a.x * b.y - a.y * b.x;
        }
        if (round % 2 == 1) { // the other way round
            std::reverse(points.begin(), points.end());
            shoelace = -shoelace;
        }
        const auto [sum, absolute] = doubled_areas(points);
        CHECK(triangulate(points).size() == points.size() - 2);
        CHECK(sum == Approx(shoelace));
        CHECK(absolute == Approx(std::abs(shoelace)));
    }
}

TEST_CASE("triangulating a polygon without area or one that crosses itself drops nothing",
          "[scene][obj]")
{
    CHECK(triangulate(std::vector<glm::dvec3>(6, glm::dvec3(1.0))).size() == 4);
    CHECK(triangulate(std::vector<glm::dvec3>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}).size() ==
          2);
    CHECK(triangulate(std::vector<glm::dvec3>{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}).size() ==
          2);
}

TEST_CASE("OBJ indices count from one or back from the last", "[scene][obj]")
{
    const Scene forward = load_obj(kSquare + "f 1 2 3\nf 1 3 4\n").scene;
    const Scene backward = load_obj(kSquare + "f -4 -3 -2\nf -4 -2 -1\n").scene;
    const Scene joined = load_obj(kSquare + "f 1 2 \\\n3\r\n\tf  1 3 4 \n").scene;
    for (const Scene* scene : {&backward, &joined}) {
        CHECK(scene->mesh.positions == forward.mesh.positions);
        CHECK(scene->mesh.corners == forward.mesh.corners);
    }
    CHECK(forward.mesh.positions.size() == 4);
}

TEST_CASE("OBJ vertices with different normals are split and normals are unit", "[scene][obj]")
{
    const Scene scene =
        load_obj(kSquare + "vn 0 0 2\nvn 0 3 4\nf 1//1 2//1 3//1\nf 1//2 3//1 4\n").scene;
    REQUIRE(scene.mesh.positions.size() == 5);
    CHECK(scene.mesh.normals[scene.mesh.corners[0].x] == glm::vec3(0, 0, 1));
    CHECK(glm::length(scene.mesh.normals[scene.mesh.corners[1].x] - glm::vec3(0, 0.6f, 0.8f)) <
          1e-6f);
    CHECK(scene.mesh.normals[scene.mesh.corners[1].z] == glm::vec3(0));
    CHECK(scene.mesh.corners[0].z == scene.mesh.corners[1].y);
}

TEST_CASE("OBJ objects are named by o, or by g where there is none", "[scene][obj]")
{
    const std::string faces = "f 1 2 3\n";
    CHECK(load_obj(kSquare + "o a\n" + faces + "g x\n" + faces + "o b\n" + faces)
              .scene.mesh.object_names == std::vector<std::string>{"a", "b"});
    CHECK(load_obj(kSquare + "g x y\n" + faces + "g z\n" + faces + "g x y\n" + faces)
              .scene.mesh.object_names == std::vector<std::string>{"x y", "z"});
    CHECK(load_obj(kSquare + faces).scene.mesh.object_names == std::vector<std::string>{"scene"});
}

TEST_CASE("bad lines of an OBJ file are refused by number", "[scene][obj][damaged]")
{
    for (const char* line :
         {"f 0 1 2", "f 1 2 5", "f 1 2 -5", "f 1 2 4294967297", "f 1 2 99999999999999999999",
          "f a b c", "f 1/1 2/1 3/1", "f 1//1 2//1 3//1", "f 1/ /2 3", "f 1.5 2 3", "v 1 2",
          "v nan 0 0", "v inf 0 0", "v 1e400 0 0", "v one two three", "vn 0 0", "vn 0 0 x",
          "f 1 2 3 # comment", "f 1 2 3/1/1/1"}) {
        INFO(line);
        CHECK_THROWS_WITH(load_obj(kSquare + "f 1 2 3\n" + line + "\nf 1 2 3\n"),
                          Catch::Contains("line 6"));
    }
    CHECK_THROWS_AS(load_obj(kSquare), InputError);
    CHECK_THROWS_AS(load_obj(""), InputError);
}

TEST_CASE("an OBJ file with any bytes changed is loaded or refused", "[scene][obj][damaged]")
{
    const std::string whole =
        kSquare + "vn 0 0 1\nvt 0 0\no a\nf 1/1/1 2//1 -2 4\ng b c\nf 1 2 3\n";
    const std::string alphabet = "0123456789-+.e/ \n\\#vfntogul\xff";
    RandomSequence random(11, RandomStream::pictures, 0, 0);
    const auto below = [&](std::size_t n) {
        return std::min(n - 1, static_cast<std::size_t>(random.next() * static_cast<float>(n)));
    };
    std::size_t loaded = 0, refused = 0;
    for (int round = 0; round < 3000; ++round) {
        std::string damaged = whole;
        for (std::size_t change = 0; change < 1 + below(3); ++change)
            damaged[below(damaged.size())] = alphabet[below(alphabet.size())];
        INFO(damaged);
        try {
            const Scene scene = load_obj(damaged).scene;
            for (const glm::uvec3& face : scene.mesh.corners)
                REQUIRE(std::max(face.x, std::max(face.y, face.z)) < scene.mesh.positions.size());
            ++loaded;
        } catch (const InputError&) {
            ++refused;
        }
    }
    CHECK(loaded > 100);
    CHECK(refused > 100);
}

TEST_CASE("lines of an OBJ file end as they do on any system", "[scene][obj]")
{
    for (const std::string end : {"\n", "\r\n", "\r"}) {
        std::string text = kSquare + "f 1 2 3 \\\n 4\n";
        for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += end.size())
            text.replace(at, 1, end);
        CHECK(load_obj(text).scene.mesh.face_count() == 2);
    }
    CHECK_THROWS_AS(load_obj(kSquare + "m 1\rf 7 8 9\n"), InputError);
}

TEST_CASE("numbers that are finite in any spelling are read", "[scene][obj]")
{
    const Scene scene =
        load_obj("v +0.0e0 -.0 0.\nv 1E+0 0 1e-400\nv 1.000000000000000000001 1 0\nf 1 2 3\n")
            .scene;
    CHECK(world(scene, 1) == glm::dvec3(1, 0, 0));
    CHECK(world(scene, 2) == glm::dvec3(1, 1, 0));
}

TEST_CASE("what an OBJ file loses is spoken of", "[scene][obj]")
{
    const LoadedScene loaded = load_obj(
        "mtllib gone.mtl\nv 0 0 0 1 0 0\nv 1 0 0\nv 0 1 0\nusemtl nowhere\nf 1 2 3\nf 1 2\n"
        "l 1 2\ncurv 0 1 2\n");
    for (const char* wanted : {"'gone.mtl'", "'nowhere'", "1 face with fewer than three corners",
                               "vertex colours", "points and lines", "curves"}) {
        INFO(wanted);
        CHECK(says(loaded.audit.warnings, wanted));
    }
    REQUIRE(loaded.scene.materials.size() == 1);
    CHECK(loaded.scene.materials[0].base_color == Rgb(0.8f));
    CHECK(loaded.scene.materials[0].specular == 0.0f);
    CHECK(loaded.scene.materials[0].metallic == 0.0f);
}

TEST_CASE("material files outside the scene's folder are not opened", "[scene][obj]")
{
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "inside");
    write_text(folder / "paint.mtl", "newmtl m\nKd 1 0 0\n");
    write_text(folder / "inside/scene.obj",
               "mtllib ../paint.mtl\n" + kSquare + "usemtl m\nf 1 2 3\n");
    const LoadedScene loaded = load_scene(folder / "inside/scene.obj", {});
    CHECK(says(loaded.audit.warnings, "outside the scene's folder"));
    REQUIRE(loaded.scene.materials.size() == 1);
    CHECK(loaded.scene.materials[0].base_color == Rgb(0.8f));
}

TEST_CASE("MTL materials become metallic-roughness ones", "[scene][obj]")
{
    const Material diffuse = only_material("Kd 0.2 0.4 0.6\nKe 1 2 3\nKs 0 0 0\nNs 100\n");
    CHECK(diffuse.base_color == Rgb(0.2f, 0.4f, 0.6f));
    CHECK(diffuse.emission == Rgb(1, 2, 3));
    CHECK(diffuse.metallic == 0.0f);
    CHECK(diffuse.specular == 0.0f);
    CHECK(diffuse.double_sided);

    const Material glossy = only_material("Kd 1 1 1\nKs 0.5 0.5 0.5\nNs 48\n");
    CHECK(glossy.specular == 1.0f);
    CHECK(glossy.roughness * glossy.roughness == Approx(std::sqrt(2.0 / 50)));

    const Material mirror = only_material("Kd 0 0 0\nKs 0.9 0.8 0.7\nillum 3\n");
    CHECK(mirror.metallic == 1.0f);
    CHECK(mirror.roughness == 0.0f);
    CHECK(mirror.base_color == Rgb(0.9f, 0.8f, 0.7f));

    const Material physical = only_material("Kd 1 1 1\nKs 0.5 0.5 0.5\nPr 0.3\nPm 0.6\nillum 3\n");
    CHECK(physical.roughness == 0.3f);
    CHECK(physical.metallic == 0.6f);
}

TEST_CASE("MTL's ways of saying transparent become transmission", "[scene][obj]")
{
    const Material glass = only_material("Kd 0 0 0\nNi 1.33\nillum 7\n");
    CHECK(glass.transmission == 1.0f);
    CHECK(glass.ior == 1.33f);
    CHECK(glass.base_color == Rgb(1.0f));
    CHECK(glass.roughness == 0.0f);
    CHECK(only_material("Kd 1 1 1\nd 0.25\n").transmission == 0.75f);
    CHECK(only_material("Kd 1 1 1\nTf 0.5 1 0.5\n").base_color == Rgb(0.5f, 1.0f, 0.5f));
    CHECK(only_material("Kd 1 1 1\nTf 1 1 1\nillum 2\n").transmission == 0.0f);
    CHECK(only_material("Kd 1 1 1\nNi 1.45\nillum 2\n").transmission == 0.0f);
}

TEST_CASE("a light without Ke and a textured MTL material are warned of", "[scene][obj]")
{
    CHECK(says(load_with_mtl("Ka 20 20 20\nKd 1 1 1\n").audit.warnings, "Ke 20 20 20"));
    CHECK_FALSE(
        says(load_with_mtl("Ka 20 20 20\nKe 5 5 5\n").audit.warnings, "looks like a light"));
    CHECK(says(load_with_mtl("Kd 1 1 1\nmap_Kd wood.png\n").audit.warnings, "texture 'wood.png'"));
    CHECK_THROWS_WITH(load_with_mtl("Ke 1e999 0 0\n"), Catch::Contains("material 'm'"));
}

} // namespace hipmap::tiny
