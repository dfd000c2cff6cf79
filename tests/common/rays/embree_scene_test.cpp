#include "common/math/random.h"
#include "common/math/sampling.h"
#include "common/rays/embree_scene.h"
#include "tests/support/tiny_meshes.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace hipmap;

namespace {

/// Nearest hit by trying every face, in double.
std::optional<double> nearest_by_hand(const TriangleMesh& mesh, const Ray& ray)
{
    std::optional<double> nearest;
    for (FaceId face = 0; face < mesh.face_count(); ++face) {
        const glm::uvec3 c = mesh.corners[face];
        const glm::dvec3 a(mesh.positions[c.x]), o(ray.origin), d(ray.direction);
        const glm::dvec3 e1 = glm::dvec3(mesh.positions[c.y]) - a;
        const glm::dvec3 e2 = glm::dvec3(mesh.positions[c.z]) - a;
        const glm::dvec3 p = glm::cross(d, e2);
        const double det = glm::dot(e1, p);
        if (det == 0)
            continue;
        const double u = glm::dot(o - a, p) / det;
        const glm::dvec3 q = glm::cross(o - a, e1);
        const double v = glm::dot(d, q) / det;
        const double t = glm::dot(e2, q) / det;
        if (u >= 0 && v >= 0 && u + v <= 1 && t > 0 && (!nearest || t < *nearest))
            nearest = t;
    }
    return nearest;
}

} // namespace

TEST_CASE("embree scene: agrees with trying every face", "[rays]")
{
    const TriangleMesh mesh = tiny::uv_sphere(24, 12);
    const EmbreeScene scene(mesh);
    int hits = 0;
    for (std::uint64_t i = 0; i < 2000; ++i) {
        RandomSequence random(7, RandomStream::pictures, 0, i);
        Ray ray;
        ray.origin = 1.5f * sample_sphere(random.next2());
        ray.direction = sample_sphere(random.next2());
        const std::optional<RayHit> hit = scene.nearest(ray);
        const std::optional<double> truth = nearest_by_hand(mesh, ray);
        REQUIRE(hit.has_value() == truth.has_value());
        CHECK(scene.occluded(ray) == truth.has_value());
        if (!hit)
            continue;
        ++hits;
        CHECK(hit->distance == Approx(*truth).epsilon(1e-5));
        ray.far = hit->distance * 0.999f;
        CHECK_FALSE(scene.nearest(ray));
        CHECK_FALSE(scene.occluded(ray));
    }
    CHECK(hits > 200);
}

TEST_CASE("embree scene: of equally near faces the lowest wins, whatever their order", "[rays]")
{
    // Sixteen copies of one square: every ray meets sixteen faces at one distance.
    for (int copies = 1; copies <= 16; ++copies) {
        TriangleMesh mesh = tiny::quad();
        for (int i = 1; i < copies; ++i)
            mesh = tiny::together(mesh, tiny::quad());
        const EmbreeScene scene(mesh);
        for (std::uint64_t i = 0; i < 100; ++i) {
            RandomSequence random(3, RandomStream::pictures, 0, i);
            Ray ray;
            const glm::vec2 at = random.next2();
            ray.origin = {at.x, at.y, 1};
            ray.direction = {0, 0, -1};
            const std::optional<RayHit> hit = scene.nearest(ray);
            REQUIRE(hit);
            CHECK(hit->face == (at.y <= at.x ? 0u : 1u));
        }
    }
}

TEST_CASE("embree scene: numbers that are not finite hit nothing and do not abort", "[rays]")
{
    const EmbreeScene scene(tiny::cube());
    const float bad[] = {NAN, INFINITY, -INFINITY, 1e30f};
    for (const float value : bad)
        for (int axis = 0; axis < 3; ++axis) {
            Ray origin, direction;
            origin.origin[axis] = value;
            direction.direction[axis] = value;
            CHECK_FALSE(scene.nearest(origin));
            CHECK_FALSE(scene.nearest(direction));
            CHECK_FALSE(scene.occluded(origin));
        }
    Ray backwards;
    backwards.near = -1;
    CHECK_FALSE(scene.nearest(backwards));
    Ray empty;
    empty.far = NAN;
    CHECK_FALSE(scene.nearest(empty));
}

TEST_CASE("embree scene: an empty mesh is never hit", "[rays]")
{
    const EmbreeScene scene(TriangleMesh{});
    CHECK_FALSE(scene.nearest(Ray{}));
    CHECK_FALSE(scene.occluded(Ray{}));
}

TEST_CASE("embree scene: the closest point is that of trying many", "[rays]")
{
    const TriangleMesh mesh = tiny::uv_sphere(24, 12);
    const EmbreeScene scene(mesh);
    for (std::uint64_t i = 0; i < 300; ++i) {
        RandomSequence random(8, RandomStream::pictures, 0, i);
        const glm::vec3 point = 2 * random.next() * sample_sphere(random.next2());
        const std::optional<glm::vec3> closest = scene.closest_point(point, 10);
        REQUIRE(closest);
        const float distance = glm::distance(point, *closest);
        CHECK_FALSE(scene.closest_point(point, 0.99f * distance));
        REQUIRE(scene.closest_point(point, 1.01f * distance) == closest);
        float least = 1e9f; // to points all over the faces
        for (const glm::uvec3& corners : mesh.corners)
            for (int a = 0; a <= 8; ++a)
                for (int b = 0; a + b <= 8; ++b) {
                    const glm::vec3 u(mesh.positions[corners.x]), v(mesh.positions[corners.y]);
                    const glm::vec3 w(mesh.positions[corners.z]);
                    const glm::vec3 at = u + (v - u) * (a / 8.0f) + (w - u) * (b / 8.0f);
                    least = std::min(least, glm::distance(point, at));
                }
        CHECK(distance <= least * (1 + 1e-5f) + 1e-6f);
        CHECK(distance >= least - 0.02f); // half of their spacing
    }
    CHECK_FALSE(EmbreeScene(TriangleMesh{}).closest_point({0, 0, 0}, 1));
    CHECK_FALSE(scene.closest_point(glm::vec3(std::nanf("")), 1));
    CHECK(scene.closest_point(mesh.positions[3], 0) == mesh.positions[3]);
}
