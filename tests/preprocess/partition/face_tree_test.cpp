#include "preprocess/partition/nearby_faces.h"
#include "preprocess/partition/self_distance.h"
#include "tests/support/hard_surfaces.h"

#include <catch2/catch.hpp>
#include <tbb/global_control.h>

#include <numeric>

using namespace hipmap;

namespace {

std::vector<FaceId> all_faces(const TriangleMesh& mesh)
{
    std::vector<FaceId> faces(mesh.face_count());
    std::iota(faces.begin(), faces.end(), 0u);
    return faces;
}

std::vector<FaceId> faces_met(const FaceTree& tree, const Bounds<glm::vec3>& box)
{
    std::vector<FaceId> found;
    tree.visit(
        box, [](const FaceTree::Range&) { return false; },
        [&](FaceId face) { found.push_back(face); });
    return found;
}

} // namespace

TEST_CASE("FaceTree: a visit misses no face and sees none twice", "[partition]")
{
    for (const std::uint64_t count : {0, 1, 3, 8, 9, 17, 500}) {
        const TriangleMesh mesh = tiny::random_mesh(count, 200, count);
        const FaceTree tree(mesh, all_faces(mesh));
        std::size_t passed_over = 0;
        for (FaceId f = 0; f < mesh.face_count(); ++f) {
            const Bounds<glm::vec3> box = face_box(mesh, f);
            std::vector<FaceId> found = faces_met(tree, box);
            std::ranges::sort(found);
            REQUIRE(std::ranges::adjacent_find(found) == found.end());
            for (FaceId g = 0; g < mesh.face_count(); ++g)
                if (meet(box, face_box(mesh, g)))
                    REQUIRE(std::ranges::binary_search(found, g));
            passed_over += mesh.face_count() - found.size();
        }
        CHECK((passed_over > 0 || count < 20));
    }
}

TEST_CASE("FaceTree: the order is the same with one and with four threads", "[partition]")
{
    const TriangleMesh mesh = tiny::uv_sphere(120, 60);
    const auto order = [&](std::size_t threads) {
        const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
        const FaceTree tree(mesh, all_faces(mesh));
        const auto faces = tree.faces(tree.root());
        return std::vector<FaceId>(faces.begin(), faces.end());
    };
    CHECK(order(1) == order(4));
}

TEST_CASE("FaceTree: refitted, a visit meets every face whose box meets the one looked for",
          "[partition]")
{
    TriangleMesh mesh = tiny::uv_sphere(24, 15);
    FaceTree tree(mesh, all_faces(mesh));
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        tiny::jitter(mesh, 0.5f, seed);
        tree.refit(mesh);
        const Bounds<glm::vec3> box{glm::vec3(-0.2f), glm::vec3(0.3f)};
        std::vector<FaceId> met, expected;
        tree.visit(
            box, [](const FaceTree::Range&) { return false; },
            [&](FaceId face) {
                if (meet(box, face_box(mesh, face)))
                    met.push_back(face);
            });
        for (FaceId face = 0; face < mesh.face_count(); ++face)
            if (meet(box, face_box(mesh, face)))
                expected.push_back(face);
        std::ranges::sort(met);
        REQUIRE(!expected.empty());
        CHECK(met == expected);
    }
}

TEST_CASE("FaceTree: a node has a label only if all of its faces do", "[partition]")
{
    const TriangleMesh mesh = tiny::uv_sphere(20, 10);
    const FaceTree tree(mesh, all_faces(mesh));
    std::vector<std::uint32_t> label_of_face;
    for (FaceId f = 0; f < mesh.face_count(); ++f)
        label_of_face.push_back(f < mesh.face_count() / 2 ? 7 : 9);
    const std::vector<std::uint32_t> labels = tree.labels_of_nodes(label_of_face);
    CHECK(labels[tree.root().node] == kNone);
    std::size_t labelled = 0;
    for (std::uint32_t i = 0; i < tree.leaf_count(); ++i) {
        const FaceTree::Range leaf = tree.leaf(i);
        const auto is_of = [&](std::uint32_t label) {
            return std::ranges::all_of(tree.faces(leaf),
                                       [&](FaceId f) { return label_of_face[f] == label; });
        };
        CHECK(labels[leaf.node] == (is_of(7) ? 7 : is_of(9) ? 9 : kNone));
        labelled += labels[leaf.node] != kNone;
    }
    CHECK(labelled > 0);
}

TEST_CASE("NearbyFaces: what is sorted out has no corner before the plane", "[partition]")
{
    std::size_t sorted_out = 0, before = 0;
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        TriangleMesh mesh = tiny::random_mesh(seed, 60, 200);
        tiny::transform(mesh, tiny::random_rotation(seed), 1, glm::vec3(seed % 7));
        const double error = position_error_of(mesh);
        const float kLarge = std::numeric_limits<float>::infinity();
        NearbyFaces nearby;
        for (FaceId f = 0; f < mesh.face_count(); ++f)
            REQUIRE(nearby.add(mesh, f, {glm::vec3(-kLarge), glm::vec3(kLarge)}));
        for (FaceId f = 0; f < mesh.face_count(); ++f) {
            const std::array<EdgePlane, 3> planes{edge_plane(mesh, f, 0), edge_plane(mesh, f, 1),
                                                  edge_plane(mesh, f, 2)};
            nearby.sort_out(planes, error);
            for (std::size_t i = 0; i < nearby.count(); ++i)
                for (int c = 0; c < 3; ++c) {
                    double highest = -1;
                    for (int corner = 0; corner < 3; ++corner)
                        highest = std::max(
                            highest, planes[c].height(glm::dvec3(
                                         mesh.positions[mesh.corners[nearby.face(i)][corner]])));
                    const bool may_be_before = nearby.front(i) >> c & 1;
                    REQUIRE((may_be_before || highest <= error));
                    sorted_out += !may_be_before;
                    before += highest > error;
                    // What shares the edge is sorted out too, however it rounds.
                    if (std::abs(highest) < 1e-3 * error)
                        CHECK_FALSE(may_be_before);
                }
        }
    }
    CHECK(sorted_out > 1000);
    CHECK(before > 1000);
}

TEST_CASE("NearbyFaces: takes what meets the box until it is full", "[partition]")
{
    const TriangleMesh mesh = tiny::quad();
    NearbyFaces nearby;
    const Bounds<glm::vec3> all{glm::vec3(-2), glm::vec3(2)};
    CHECK(nearby.add(mesh, 0, {glm::vec3(3), glm::vec3(4)}));
    CHECK(nearby.count() == 0);
    for (std::size_t i = 0; i < NearbyFaces::kMost; ++i)
        REQUIRE(nearby.add(mesh, 1, all));
    CHECK(nearby.count() == NearbyFaces::kMost);
    CHECK_FALSE(nearby.add(mesh, 1, all));
    nearby.clear();
    CHECK(nearby.count() == 0);
}
