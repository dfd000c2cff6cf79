#include "common/math/random.h"
#include "common/math/sampling.h"
#include "common/rays/surface_point.h"
#include "tests/support/tiny_meshes.h"

#include <catch2/catch.hpp>

using namespace hipmap;

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
