#include "common/rays/embree_scene.h"
#include "preprocess/partition/build_partition.h"
#include "render/shading/part_touching_faces.h"
#include "tests/support/tiny_meshes.h"
#include "tests/support/tiny_scenes.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

constexpr MaterialId kFloor = 0, kUpper = 1;

/// A square of side 2 in the plane y = -0.5, facing up.
TriangleMesh floor_quad()
{
    return tiny::make_mesh({{-1, -0.5f, 1}, {1, -0.5f, 1}, {1, -0.5f, -1}, {-1, -0.5f, -1}},
                           {{0, 1, 2}, {0, 2, 3}});
}

/// The mesh on the floor, as an object of its own.
Scene on_floor(const TriangleMesh& upper, const Material& material)
{
    Scene scene = tiny::make_scene(tiny::together(floor_quad(), upper));
    scene.materials = {tiny::diffuse({0.5f, 0.5f, 0.5f}), material};
    scene.mesh.object_names = {"floor", "upper"};
    for (FaceId face = 2; face < scene.mesh.face_count(); ++face) {
        scene.mesh.material_of_face[face] = kUpper;
        scene.mesh.object_of_face[face] = 1;
    }
    scene.mesh.material_of_face[0] = scene.mesh.material_of_face[1] = kFloor;
    return scene;
}

/// The faces, from above, that a ray through (x, z) meets.
std::vector<FaceId> met_from_above(const Scene& scene, float x, float z)
{
    std::vector<FaceId> out;
    const EmbreeScene rays(scene.mesh);
    Ray ray{{x, 2, z}, {0, -1, 0}};
    while (const std::optional<RayHit> hit = rays.nearest(ray)) {
        out.push_back(hit->face);
        ray.near = std::nextafter(hit->distance, ray.far);
    }
    return out;
}

Material emissive()
{
    Material material = tiny::diffuse({0, 0, 0});
    material.emission = Rgb(1);
    return material;
}

/// As `floor_quad`, at half its size.
TriangleMesh smaller_quad(bool upwards)
{
    TriangleMesh mesh = floor_quad();
    for (glm::vec3& p : mesh.positions)
        p = {p.x / 2, p.y, p.z / 2};
    for (glm::uvec3& c : mesh.corners)
        if (!upwards)
            std::swap(c.y, c.z);
    return mesh;
}

} // namespace

TEST_CASE("part_touching_faces: glass on a floor moves into itself", "[shading]")
{
    Scene scene = on_floor(tiny::cube(), tiny::glass(1.5f));
    const Partition partition = build_partition(scene, {}).partition;
    const std::vector<glm::vec3> before = scene.mesh.positions;
    CHECK(part_touching_faces(scene, partition) == 2);
    for (std::size_t i = 0; i < before.size(); ++i) {
        const bool moves = i >= 4 && before[i].y == -0.5f;
        const float up = scene.mesh.positions[i].y - before[i].y;
        CHECK(up == Approx(moves ? 8 * partition.position_error : 0).margin(1e-7));
        CHECK(scene.mesh.positions[i].x == before[i].x);
        CHECK(scene.mesh.positions[i].z == before[i].z);
    }
    const std::vector<FaceId> met = met_from_above(scene, 0.13f, 0.29f);
    REQUIRE(met.size() == 3);
    CHECK(met.back() < 2);
}

TEST_CASE("part_touching_faces: a pane on a floor moves to the front of the floor", "[shading]")
{
    for (const bool upwards : {true, false}) {
        Scene scene = on_floor(smaller_quad(upwards), tiny::glass(1.5f));
        const Partition partition = build_partition(scene, {}).partition;
        CHECK(part_touching_faces(scene, partition) == 2);
        CHECK(scene.mesh.positions[4].y > -0.5f + 7 * partition.position_error);
        CHECK(scene.mesh.positions[0].y == -0.5f);
    }
}

TEST_CASE("part_touching_faces: what emits moves forwards", "[shading]")
{
    for (const bool upwards : {true, false}) {
        Scene scene = on_floor(smaller_quad(upwards), emissive());
        const Partition partition = build_partition(scene, {}).partition;
        CHECK(part_touching_faces(scene, partition) == 2);
        const float up = scene.mesh.positions[4].y + 0.5f;
        CHECK((upwards ? up : -up) > 7 * partition.position_error);
    }
}

TEST_CASE("part_touching_faces: nothing else moves", "[shading]")
{
    TriangleMesh beside = tiny::cube(); // its top is at the height of the floor, but beside it
    for (glm::vec3& p : beside.positions)
        p += glm::vec3(1.5f, -1, 0);
    TriangleMesh above = tiny::cube();
    for (glm::vec3& p : above.positions)
        p.y += 0.01f;
    Material leaf = tiny::diffuse({0.5f, 0.5f, 0.5f}); // its map is the floor's
    leaf.diffuse_transmission = 0.5f;
    for (Scene scene : {on_floor(smaller_quad(true), leaf),
                        on_floor(tiny::cube(), tiny::diffuse({0.5f, 0.5f, 0.5f})),
                        on_floor(beside, tiny::glass(1.5f)), on_floor(above, tiny::glass(1.5f))}) {
        const Partition partition = build_partition(scene, {}).partition;
        const std::vector<glm::vec3> before = scene.mesh.positions;
        CHECK(part_touching_faces(scene, partition) == 0);
        CHECK(scene.mesh.positions == before);
    }
}

TEST_CASE("part_touching_faces: glass that shares a side with glass leaves air between",
          "[shading]")
{
    TriangleMesh right = tiny::cube();
    for (glm::vec3& p : right.positions)
        p += glm::vec3(1, 1, 0);
    TriangleMesh left = tiny::cube();
    for (glm::vec3& p : left.positions)
        p.y += 1;
    Scene scene = on_floor(tiny::together(left, right), tiny::glass(1.5f));
    for (FaceId face = 14; face < scene.mesh.face_count(); ++face)
        scene.mesh.object_of_face[face] = 2;
    scene.mesh.object_names.emplace_back("right");
    const Partition partition = build_partition(scene, {}).partition;
    CHECK(part_touching_faces(scene, partition) == 4);
    float most = -1, least = 1;
    for (std::size_t i = 4; i < scene.mesh.positions.size(); ++i)
        if (const float x = scene.mesh.positions[i].x; std::abs(x - 0.5f) < 0.1f)
            (i < 28 ? most : least) = x;
    CHECK(least - most == Approx(16 * partition.position_error).epsilon(0.05));
}
