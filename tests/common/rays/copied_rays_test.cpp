#include "common/math/random.h"
#include "common/math/sampling.h"
#include "common/rays/embree_scene.h"
#include "common/rays/surface_point.h"
#include "tests/support/copied_mesh.h"

#include <catch2/catch.hpp>

#include <set>

using namespace hipmap;

namespace {

TriangleMesh balls()
{
    TriangleMesh ball = tiny::uv_sphere(30, 16);
    ball.normals = ball.positions;
    for (glm::vec3& p : ball.positions)
        p = 0.1f * p + glm::vec3(-0.2f, 0.1f, 0.3f);
    TriangleMesh mesh = tiny::with_copies(tiny::quad(), ball, tiny::some_places());
    std::copy(ball.normals.begin(), ball.normals.end(),
              mesh.normals.end() - static_cast<std::ptrdiff_t>(ball.normals.size()));
    return mesh;
}

Ray some_ray(std::uint64_t number)
{
    RandomSequence random(5, RandomStream::photons, 0, number);
    const glm::vec2 a = random.next2();
    Ray ray;
    ray.origin = glm::vec3(a, random.next()) * 1.6f - 0.8f;
    ray.direction = sample_sphere(random.next2());
    return ray;
}

} // namespace

TEST_CASE("embree scene: copies are hit as if they were stored", "[rays][copies]")
{
    const TriangleMesh mesh = balls(), all = tiny::stored(mesh);
    const EmbreeScene copied(mesh), stored(all);
    int hits = 0, others = 0, on_copies = 0;
    for (std::uint64_t i = 0; i < 20'000; ++i) {
        const Ray ray = some_ray(i);
        const auto a = copied.nearest(ray), b = stored.nearest(ray);
        CHECK(copied.occluded(ray) == a.has_value());
        if (a.has_value() != b.has_value() || (a && a->face != b->face)) {
            ++others; // past an edge, by rounding
            continue;
        }
        if (!a)
            continue;
        ++hits;
        on_copies += mesh.is_copied(a->face) ? 1 : 0;
        CHECK(a->distance == Approx(b->distance).margin(2e-5));
        const SurfacePoint at = surface_point(mesh, a->face, a->barycentric);
        const SurfacePoint wanted = surface_point(all, a->face, a->barycentric);
        CHECK(glm::distance(at.position, wanted.position) < 5e-7f);
        CHECK(glm::dot(at.geometric_normal, wanted.geometric_normal) > 0.9999f);
        CHECK(glm::dot(at.shading_normal, wanted.shading_normal) > 0.9999f);
    }
    CHECK(on_copies > 400);
    CHECK(hits - on_copies > 400);
    CHECK(others < 20);
}

TEST_CASE("embree scene: a ray that leaves a copy does not meet the face it left", "[rays][copies]")
{
    const TriangleMesh mesh = balls();
    const EmbreeScene rays(mesh);
    int left = 0;
    for (std::uint64_t i = 0; i < 40'000; ++i) {
        const auto hit = rays.nearest(some_ray(i));
        if (!hit || !mesh.is_copied(hit->face))
            continue;
        const SurfacePoint at = surface_point(mesh, hit->face, hit->barycentric);
        RandomSequence random(6, RandomStream::photons, 0, i);
        Ray out;
        out.direction = sample_sphere(random.next2());
        out.origin = offset_origin(at, out.direction);
        const auto again = rays.nearest(out);
        ++left;
        CHECK((!again || again->face != hit->face));
        // The ball is convex: away from it, it is not met at all.
        if (glm::dot(out.direction, at.geometric_normal) > 0)
            CHECK((!again ||
                   &mesh.copy_of(hit->face) !=
                       (mesh.is_copied(again->face) ? &mesh.copy_of(again->face) : nullptr)));
    }
    CHECK(left > 1000);
}

TEST_CASE(
    "embree scene: a ray that leaves a copy of a thousandth of the scene does not meet it again",
    "[rays][copies]")
{
    TriangleMesh ball = tiny::uv_sphere(30, 16);
    const glm::vec3 centre(0.43f, 0.31f, -0.47f);
    for (glm::vec3& p : ball.positions)
        p = 0.001f * p + centre;
    const TriangleMesh mesh =
        tiny::with_copies(tiny::make_mesh({}, {}), ball,
                          {tiny::place_at({-0.9, 0.02, 0.1}, 20, 1.3, {1, 3, 2}),
                           tiny::place_at({0, 0, 0.9}, 99, 0.6)});
    const EmbreeScene rays(mesh);
    for (const FaceCopy& copy : mesh.copies)
        for (std::uint64_t i = 0; i < 5000; ++i) {
            RandomSequence random(7, RandomStream::photons, 0, i);
            const glm::vec3 at(copy.place.point(glm::dvec3(centre)));
            Ray in;
            in.direction = -sample_sphere(random.next2());
            in.origin = at - 0.1f * in.direction;
            const auto hit = rays.nearest(in);
            REQUIRE(hit);
            const SurfacePoint point = surface_point(mesh, hit->face, hit->barycentric);
            CHECK(std::abs(glm::distance(point.position, at) / copy.place.scale - 0.001) < 2e-5);
            CHECK(glm::length(point.position_error) < 0.003 * copy.place.scale);
            Ray out;
            out.direction = sample_sphere(random.next2());
            if (glm::dot(out.direction, point.geometric_normal) < 0)
                out.direction = -out.direction;
            out.origin = offset_origin(point, out.direction);
            CHECK_FALSE(rays.nearest(out));
            CHECK_FALSE(rays.occluded(ray_between(point, point.position + 0.5f * out.direction)));
        }
}

TEST_CASE("embree scene: the closest points and the faces near by are those of copies, too",
          "[rays][copies]")
{
    const TriangleMesh mesh = balls(), all = tiny::stored(mesh);
    const EmbreeScene copied(mesh), stored(all);
    for (std::uint64_t i = 0; i < 250; ++i) {
        const glm::vec3 point = some_ray(i).origin;
        const auto a = copied.closest_point(point, 0.3f), b = stored.closest_point(point, 0.3f);
        REQUIRE(a.has_value() == b.has_value());
        if (a)
            CHECK(glm::distance(*a, *b) < 1e-5f);
        std::set<FaceId> near, wanted;
        copied.visit_near(point, 0.1f, [&](FaceId face) { near.insert(face); });
        for (FaceId face = 0; face < all.face_count(); ++face) {
            TriangleMesh one;
            const auto corners = all.triangle(face);
            one.positions.assign(corners.begin(), corners.end());
            one.corners = {{0, 1, 2}};
            if (i < 10 && EmbreeScene(one).closest_point(point, 0.099f))
                CHECK(near.contains(face));
        }
    }
}

TEST_CASE("embree scene: opacity is asked about faces of copies", "[rays][copies]")
{
    const TriangleMesh mesh = balls();
    const FaceId last = mesh.finder.first_face(2);
    const EmbreeScene rays(
        mesh, [&](FaceId face, const glm::vec2&) { return face >= last ? 0.0f : 1.0f; });
    int met = 0;
    for (std::uint64_t i = 0; i < 5000; ++i)
        if (const auto hit = rays.nearest(some_ray(i)); hit && mesh.is_copied(hit->face)) {
            CHECK(hit->face < last);
            ++met;
        }
    CHECK(met > 100);
}
