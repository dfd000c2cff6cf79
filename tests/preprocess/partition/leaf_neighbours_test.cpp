#include "preprocess/partition/leaf_neighbours.h"
#include "tests/support/hard_surfaces.h"

#include <catch2/catch.hpp>

#include <numeric>

using namespace hipmap;

namespace {

FaceTree tree_of_all(const TriangleMesh& mesh)
{
    std::vector<FaceId> faces(mesh.face_count());
    std::iota(faces.begin(), faces.end(), 0u);
    return {mesh, faces};
}

const auto kSkipNothing = [](const FaceTree::Range&) { return false; };

} // namespace

TEST_CASE("LeafNeighbours: visits what a walk through the tree finds, in its order", "[partition]")
{
    const TriangleMesh mesh = tiny::random_mesh(7, 1500, 1500);
    const FaceTree tree = tree_of_all(mesh);
    LeafNeighbours near;
    for (std::uint32_t i = 0; i < tree.leaf_count(); ++i) {
        REQUIRE(near.gather(mesh, tree, tree.box(tree.leaf(i)), kSkipNothing));
        for (const FaceId face : tree.faces(tree.leaf(i))) {
            const Bounds<glm::vec3> box = face_box(mesh, face);
            std::vector<FaceId> expected, found;
            tree.visit(box, kSkipNothing, [&](FaceId other) {
                if (meet(box, face_box(mesh, other)))
                    expected.push_back(other);
            });
            near.visit(box, [&](const BoxedFace& other) {
                found.push_back(other.face);
                return true;
            });
            REQUIRE(found == expected);
        }
    }
}

TEST_CASE("LeafNeighbours: gives up more faces than it may hold", "[partition]")
{
    const TriangleMesh mesh = tiny::uv_sphere(80, 40);
    REQUIRE(mesh.face_count() > LeafNeighbours::kMost);
    const FaceTree tree = tree_of_all(mesh);
    LeafNeighbours near;
    CHECK(!near.gather(mesh, tree, tree.box(tree.root()), kSkipNothing));
    CHECK(near.gather(mesh, tree, tree.box(tree.leaf(0)), kSkipNothing));
}

TEST_CASE("LeafNeighbours: a visit ends when it is told to", "[partition]")
{
    const TriangleMesh mesh = tiny::cube();
    const FaceTree tree = tree_of_all(mesh);
    LeafNeighbours near;
    REQUIRE(near.gather(mesh, tree, tree.box(tree.root()), kSkipNothing));
    int count = 0;
    near.visit(tree.box(tree.root()), [&](const BoxedFace&) { return ++count < 5; });
    CHECK(count == 5);
}
