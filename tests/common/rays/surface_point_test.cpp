#include "common/math/random.h"
#include "common/math/sampling.h"
#include "common/rays/flat_point.h"
#include "common/rays/surface_point.h"
#include "tests/support/copied_mesh.h"
#include "tests/support/tiny_meshes.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using namespace hipmap;

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// The formula of offset_origin, by the library's function.
glm::vec3 plainly_offset(const SurfacePoint& point, const glm::vec3& direction)
{
    const glm::vec3 n = point.geometric_normal;
    const float distance = glm::dot(glm::abs(n), point.position_error);
    const glm::vec3 offset = glm::dot(direction, n) < 0 ? -distance * n : distance * n;
    glm::vec3 out = point.position + offset;
    for (int i = 0; i < 3; ++i)
        if (offset[i] != 0)
            out[i] = std::nextafter(out[i], offset[i] > 0 ? kInfinity : -kInfinity);
    return out;
}

} // namespace

TEST_CASE("surface point: a ray that leaves a face does not meet it again", "[rays]")
{
    // Far from the origin rounding is coarse: there a constant offset would fail.
    for (const float far : {0.0f, 1.0f, 1000.0f}) {
        TriangleMesh mesh = tiny::uv_sphere(16, 8);
        for (glm::vec3& p : mesh.positions)
            p += far;
        const EmbreeScene scene(mesh);
        for (std::uint64_t i = 0; i < 5000; ++i) {
            RandomSequence random(1, RandomStream::pictures, 0, i);
            const auto face =
                static_cast<FaceId>(random.next() * static_cast<float>(mesh.face_count()));
            const SurfacePoint point = surface_point(mesh, face, sample_triangle(random.next2()));
            Ray out;
            out.direction = sample_sphere(random.next2());
            if (glm::dot(out.direction, point.geometric_normal) < 0)
                out.direction = -out.direction;
            out.origin = offset_origin(point, out.direction);
            CHECK_FALSE(scene.nearest(out)); // the sphere is convex
        }
    }
}

TEST_CASE("surface point: a shading normal lies on the side of the geometric one", "[rays]")
{
    TriangleMesh mesh = tiny::quad();
    mesh.normals.assign(4, glm::vec3(0, 0, -1));
    CHECK(surface_point(mesh, 0, {0.2f, 0.2f}).shading_normal == glm::vec3(0, 0, 1));
    mesh.normals.assign(4, glm::vec3(0));
    CHECK(surface_point(mesh, 0, {0.2f, 0.2f}).shading_normal == glm::vec3(0, 0, 1));
    mesh.normals.assign(4, glm::normalize(glm::vec3(1, 0, 1)));
    CHECK(surface_point(mesh, 0, {0.2f, 0.2f}).shading_normal.x == Approx(std::sqrt(0.5)));
}

TEST_CASE("surface point: a ray between two points ends short of the second", "[rays]")
{
    const TriangleMesh mesh = tiny::cube();
    const EmbreeScene scene(mesh);
    for (FaceId from = 0; from < mesh.face_count(); ++from) {
        const SurfacePoint a = surface_point(mesh, from, {0.3f, 0.3f});
        const Ray ray = ray_between(a, {0.01f, 0.02f, 0.03f});
        CHECK_FALSE(scene.occluded(ray));
        CHECK(scene.occluded({ray.origin, ray.direction, 0.0f, 10.0f}));
    }
}

TEST_CASE("surface point: a ray to a point of a face does not meet that face", "[rays]")
{
    // Slanted, so that a point of the face is rounded to either side of it; far from the origin by
    // more than a share of the way could make up for.
    for (const float far : {0.0f, 1.0f, 1000.0f}) {
        TriangleMesh mesh = tiny::quad();
        for (glm::vec3& p : mesh.positions)
            p = glm::vec3(far) + glm::vec3(p.x, p.y, 0.3f * p.x + 0.7f * p.y);
        const EmbreeScene scene(mesh);
        for (std::uint64_t i = 0; i < 5000; ++i) {
            RandomSequence random(1, RandomStream::pictures, 0, i);
            const SurfacePoint to = surface_point(mesh, i % 2, sample_triangle(random.next2()));
            SurfacePoint from;
            from.position = to.position + 0.1f * sample_sphere(random.next2());
            if (std::abs(glm::dot(from.position - to.position, to.geometric_normal)) > 0.01f)
                CHECK_FALSE(scene.occluded(ray_between(from, to)));
        }
    }
}

TEST_CASE("surface point: an origin goes on to the next float on either side of zero", "[rays]")
{
    const float smallest = std::numeric_limits<float>::denorm_min();
    const float largest = std::numeric_limits<float>::max();
    for (const float at : {0.0f, -0.0f, smallest, -smallest, 1.0f, -1.0f, 0.3f, -700.0f, largest,
                           -largest, kInfinity})
        for (const float error : {0.0f, smallest, 1e-7f, 2.0f, 1e30f})
            for (const float side : {1.0f, -1.0f}) {
                SurfacePoint point;
                point.position = {at, -at, 0.5f * at};
                point.position_error = glm::vec3(error);
                point.geometric_normal = glm::normalize(glm::vec3(1, -0.5f, 0));
                const glm::vec3 direction = side * point.geometric_normal;
                CHECK(offset_origin(point, direction) == plainly_offset(point, direction));
            }
}

TEST_CASE("surface point: a flat point differs by its shading normal alone", "[rays]")
{
    TriangleMesh ball = tiny::uv_sphere(16, 8);
    ball.normals = ball.positions;
    const TriangleMesh mesh = tiny::with_copies(tiny::quad(), ball, tiny::some_places());
    for (FaceId face = 0; face < mesh.all_face_count(); ++face) {
        const SurfacePoint point = surface_point(mesh, face, {0.2f, 0.3f});
        const SurfacePoint flat = flat_point(mesh, face, {0.2f, 0.3f});
        CHECK(flat.face == face);
        CHECK(flat.position == point.position);
        CHECK(flat.position_error == point.position_error);
        CHECK(flat.geometric_normal == point.geometric_normal);
        CHECK(flat.shading_normal == point.geometric_normal);
    }
}
