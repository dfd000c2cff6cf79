#include "common/math/random.h"
#include "common/scene/framing_camera.h"
#include "tests/support/copied_mesh.h"

#include <catch2/catch.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>

using namespace hipmap;

namespace {

TriangleMesh sample()
{
    TriangleMesh ball = tiny::uv_sphere(9, 5);
    for (glm::vec3& p : ball.positions)
        p = 0.1f * p + glm::vec3(-0.2f, 0.1f, 0.3f);
    return tiny::with_copies(tiny::quad(), ball, tiny::some_places());
}

using Triangle = std::array<std::array<float, 3>, 3>;

std::vector<Triangle> triangles(const TriangleMesh& mesh)
{
    std::vector<Triangle> out;
    for (FaceId face = 0; face < mesh.all_face_count(); ++face) {
        const auto corners = mesh.triangle(face);
        Triangle triangle;
        for (std::size_t c = 0; c < 3; ++c)
            triangle[c] = {corners[c].x, corners[c].y, corners[c].z};
        out.push_back(triangle);
    }
    return out;
}

/// The farthest corner of a triangle of `a` from the nearest triangle of `b`.
float farthest(const std::vector<Triangle>& a, const std::vector<Triangle>& b)
{
    float out = 0;
    for (const Triangle& one : a) {
        float nearest = INFINITY;
        for (const Triangle& other : b) {
            float off = 0;
            for (std::size_t c = 0; c < 3; ++c)
                for (std::size_t axis = 0; axis < 3; ++axis)
                    off = std::max(off, std::abs(one[c][axis] - other[c][axis]));
            nearest = std::min(nearest, off);
        }
        out = std::max(out, nearest);
    }
    return out;
}

} // namespace

TEST_CASE("copy finder: finds what a search of all copies finds", "[scene][copies]")
{
    RandomSequence random(1, RandomStream::photons, 0, 0);
    std::vector<FaceId> first{7};
    for (int i = 0; i < 200; ++i)
        first.push_back(first.back() + 1 +
                        static_cast<FaceId>(random.next() * (i % 9 == 0 ? 900 : 12)));
    const FaceId end = first.back() + 5;
    const CopyFinder finder(first, end);
    for (FaceId face = 7; face < end; ++face) {
        const auto next = std::upper_bound(first.begin(), first.end(), face);
        REQUIRE(finder.copy_of(face) == next - first.begin() - 1);
    }
}

TEST_CASE("similarity: a transform is one unless it stretches, shears or mirrors",
          "[scene][copies]")
{
    const glm::dmat4 turned = glm::rotate(glm::translate(glm::dmat4(1.0), {3, -2, 5}), 0.7,
                                          glm::normalize(glm::dvec3(1, 2, 3)));
    const std::optional<Similarity> found = to_similarity(glm::scale(turned, glm::dvec3(2.5)));
    REQUIRE(found);
    CHECK(found->scale == Approx(2.5));
    const glm::dvec3 p(0.3, -4, 7), there(glm::scale(turned, glm::dvec3(2.5)) * glm::dvec4(p, 1));
    CHECK(glm::distance(found->point(p), there) < 1e-12);
    CHECK(glm::distance(found->point_back(there), p) < 1e-12);
    CHECK(glm::distance(inverse(*found).point(there), p) < 1e-12);
    CHECK(glm::distance(compose(*found, *found).point(p), found->point(found->point(p))) < 1e-9);
    CHECK_FALSE(to_similarity(glm::scale(turned, {1, 1, 1.001})));
    CHECK_FALSE(to_similarity(glm::scale(turned, {-1, 1, 1})));
    CHECK_FALSE(to_similarity(glm::scale(turned, {0, 0, 0})));
    glm::dmat4 sheared(1.0);
    sheared[1][0] = 0.01;
    CHECK_FALSE(to_similarity(sheared));
}

TEST_CASE("store copies: the same faces under the same numbers", "[scene][copies]")
{
    const TriangleMesh mesh = sample();
    const TriangleMesh all = tiny::stored(mesh);
    REQUIRE(all.face_count() == mesh.all_face_count());
    CHECK(all.copies.empty());
    CHECK(triangles(all) == triangles(mesh));
    for (FaceId face = 0; face < all.face_count(); ++face) {
        CHECK(all.object_of_face[face] == mesh.object_of(face));
        CHECK(face_area(all, face) == Approx(face_area(mesh, face)).epsilon(1e-4));
        CHECK(glm::dot(scaled_normal(all, face), scaled_normal(mesh, face)) > 0);
    }
    CHECK(bounds_of(all).low == bounds_of(mesh).low);
    CHECK(bounds_of(all).high == bounds_of(mesh).high);
}

TEST_CASE("set apart: the same faces in the same places, those of the others still copies",
          "[scene][copies]")
{
    const TriangleMesh mesh = sample();
    const auto faces_of_one = mesh.shared[0].count;
    for (const std::vector<std::uint32_t>& places :
         std::vector<std::vector<std::uint32_t>>{{}, {2}, {0}, {0, 1}, {1, 3}, {0, 1, 2, 3}}) {
        TriangleMesh apart = mesh;
        set_apart(apart, places);
        CHECK(apart.copies.size() == (places.size() == 4 ? 0 : 3 - places.size()));
        CHECK(apart.face_count() ==
              mesh.face_count() + faces_of_one * (places.size() == 4 ? 3 : places.size()));
        REQUIRE(apart.all_face_count() == mesh.all_face_count());
        CHECK(farthest(triangles(mesh), triangles(apart)) < 2e-7f);
        CHECK(farthest(triangles(apart), triangles(mesh)) < 2e-7f);
        std::vector<int> count(5, 0);
        for (FaceId face = 0; face < apart.all_face_count(); ++face)
            ++count[apart.object_of(face)];
        for (std::size_t object = 1; object < 5; ++object)
            CHECK(count[object] == static_cast<int>(faces_of_one));
    }
}

TEST_CASE("framing camera: sees copies", "[scene][copies]")
{
    const TriangleMesh mesh = sample();
    const Camera camera = framing_camera(mesh), wanted = framing_camera(tiny::stored(mesh));
    CHECK(camera.name == wanted.name);
    CHECK(camera.position == wanted.position);
}
