#include "common/math/sampling.h"
#include "preprocess/prediction/tree_rays.h"
#include "tests/support/tiny_scenes.h"

#include <catch2/catch.hpp>

#include <numeric>

using namespace hipmap;

namespace {

FaceTree tree_of(const TriangleMesh& mesh)
{
    std::vector<FaceId> faces(mesh.face_count());
    std::iota(faces.begin(), faces.end(), 0u);
    return {mesh, faces};
}

} // namespace

TEST_CASE("nearest_in_tree: finds the faces that Embree finds", "[prediction]")
{
    TriangleMesh mesh = tiny::together(tiny::uv_sphere(40, 20), tiny::floor_at(-0.7f, 6));
    const FaceTree tree = tree_of(mesh);
    const EmbreeScene embree(mesh);
    std::size_t hits = 0, differ = 0;
    for (std::uint64_t i = 0; i < 20'000; ++i) {
        RandomSequence random(1, RandomStream::pictures, 0, i);
        Ray ray;
        ray.origin = 1.5f * sample_sphere(random.next2());
        ray.direction = sample_sphere(random.next2());
        const std::optional<RayHit> found = nearest_in_tree(mesh, tree, ray);
        const std::optional<RayHit> expected = embree.nearest(ray);
        hits += expected ? 1 : 0;
        if (found.has_value() != expected.has_value() || (found && found->face != expected->face)) {
            ++differ; // on an edge
            continue;
        }
        if (!found)
            continue;
        REQUIRE(found->distance == Approx(expected->distance).epsilon(1e-4).margin(1e-5));
        REQUIRE(glm::length(found->barycentric - expected->barycentric) < 1e-2f);
    }
    CHECK(hits > 5000);
    CHECK(differ <= 2);
}

TEST_CASE("nearest_in_tree: nothing lies outside near and far, nor in an empty tree",
          "[prediction]")
{
    const TriangleMesh mesh = tiny::quad();
    Ray ray;
    ray.origin = {0.6f, 0.3f, 2};
    ray.direction = {0, 0, -1};
    const FaceTree tree = tree_of(mesh);
    REQUIRE(nearest_in_tree(mesh, tree, ray));
    CHECK(nearest_in_tree(mesh, tree, ray)->distance == 2);
    CHECK(!nearest_in_tree(mesh, FaceTree(), ray));
    ray.far = 1.5f;
    CHECK(!nearest_in_tree(mesh, tree, ray));
    ray.far = 4;
    ray.near = 2.5f;
    CHECK(!nearest_in_tree(mesh, tree, ray));
}
