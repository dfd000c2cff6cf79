#include "common/scene/framing_camera.h"
#include "tests/support/tiny_meshes.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

/// A box without its -Z side, fronts inward: a room to be looked into from behind.
TriangleMesh room_open_behind()
{
    TriangleMesh room = tiny::cube();
    std::vector<glm::uvec3> corners;
    for (FaceId face = 0; face < room.face_count(); ++face)
        if (!(scaled_normal(room, face).z < -0.5))
            corners.emplace_back(room.corners[face].x, room.corners[face].z, room.corners[face].y);
    return tiny::make_mesh(room.positions, corners);
}

} // namespace

TEST_CASE("framing camera: closed meshes are seen from the front, rooms through their opening",
          "[scene]")
{
    CHECK(framing_camera(tiny::cube()).position.z > 0.5f);
    CHECK(framing_camera(room_open_behind()).position.z < -0.5f);
    CHECK(framing_camera(tiny::quad()).position.z > 0.5f);
}

TEST_CASE("framing camera: every vertex is in view", "[scene]")
{
    for (const TriangleMesh& mesh : {tiny::cube(), room_open_behind(), tiny::uv_sphere(16, 8)}) {
        const Camera camera = framing_camera(mesh);
        for (const glm::vec3& position : mesh.positions) {
            const glm::vec3 off = position - camera.position;
            const float depth = glm::dot(off, camera.forward);
            CHECK(depth > 0);
            CHECK(std::abs(glm::dot(off, camera.up)) < camera.tan_half_height * depth);
            CHECK(std::abs(glm::dot(off, camera.right)) < camera.tan_half_height * depth);
        }
    }
}
