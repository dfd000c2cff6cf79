#include "common/math/random.h"
#include "common/rays/embree_scene.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_meshes.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

/// Squares at heights 0, 1, ... over the unit square.
TriangleMesh pile(int squares)
{
    TriangleMesh mesh = tiny::quad();
    for (int i = 1; i < squares; ++i) {
        TriangleMesh next = tiny::quad();
        for (glm::vec3& p : next.positions)
            p.z += static_cast<float>(i);
        mesh = tiny::together(mesh, next);
    }
    return mesh;
}

/// A ray down onto the pile.
Ray ray_down(std::uint64_t i)
{
    RandomSequence random(11, RandomStream::pictures, 0, i);
    const glm::vec2 at = random.next2();
    Ray ray;
    ray.origin = {at.x, at.y, 10};
    ray.direction = {0, 0, -1};
    return ray;
}

RunningMean share_stopped(const EmbreeScene& scene)
{
    RunningMean out;
    for (std::uint64_t i = 0; i < 20000; ++i)
        out.add(scene.occluded(ray_down(i)) ? 1 : 0);
    return out;
}

} // namespace

TEST_CASE("opacity: faces stop their shares of all rays, each for itself", "[rays]")
{
    const auto quarter = [](FaceId, const glm::vec2&) { return 0.25f; };
    CHECK(std::abs(share_stopped(EmbreeScene(pile(1), quarter)).z_score(0.25)) < kMostZ);
    CHECK(std::abs(share_stopped(EmbreeScene(pile(3), quarter)).z_score(1 - 27.0 / 64)) < kMostZ);
    const EmbreeScene none(pile(2), [](FaceId, const glm::vec2&) { return 0.0f; });
    const EmbreeScene all(pile(2), [](FaceId, const glm::vec2&) { return 1.0f; });
    CHECK(share_stopped(none).mean() == 0);
    CHECK(share_stopped(all).mean() == 1);
}

TEST_CASE("opacity: a ray meets the same face whenever it is asked", "[rays]")
{
    const EmbreeScene scene(pile(4), [](FaceId, const glm::vec2&) { return 0.4f; });
    std::size_t passed = 0;
    for (std::uint64_t i = 0; i < 2000; ++i) {
        Ray ray = ray_down(i);
        const std::optional<RayHit> hit = scene.nearest(ray);
        CHECK(hit.has_value() == scene.occluded(ray));
        passed += hit && hit->face < 6 ? 1 : 0;
        if (!hit)
            continue;
        CHECK(scene.nearest(ray)->face == hit->face);
        ray.far = 0.99f * hit->distance; // what was passed is not there for a shadow ray either
        CHECK_FALSE(scene.occluded(ray));
    }
    CHECK(passed > 500);
}

TEST_CASE("opacity: a hole ends where its face says", "[rays]")
{
    const TriangleMesh mesh = tiny::quad();
    const EmbreeScene scene(mesh, [&](FaceId face, const glm::vec2& b) {
        const glm::uvec3 c = mesh.corners[face];
        const glm::vec3 at = mesh.positions[c.x] * (1 - b.x - b.y) + mesh.positions[c.y] * b.x +
                             mesh.positions[c.z] * b.y;
        return at.x < 0.3f ? 0.0f : 1.0f;
    });
    for (std::uint64_t i = 0; i < 1000; ++i) {
        const Ray ray = ray_down(i);
        if (std::abs(ray.origin.x - 0.3f) > 1e-5f)
            CHECK(scene.occluded(ray) == (ray.origin.x > 0.3f));
    }
}

TEST_CASE("opacity: nearest_face meets faces that let the ray pass", "[rays]")
{
    const EmbreeScene scene(pile(4), [](FaceId, const glm::vec2&) { return 0.0f; });
    const EmbreeScene opaque(pile(4));
    for (std::uint64_t i = 0; i < 100; ++i) {
        CHECK_FALSE(scene.nearest(ray_down(i)));
        const std::optional<RayHit> hit = scene.nearest_face(ray_down(i));
        REQUIRE(hit);
        CHECK(hit->face == opaque.nearest(ray_down(i))->face);
    }
}
