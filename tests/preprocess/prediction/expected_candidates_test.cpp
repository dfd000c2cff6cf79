#include "preprocess/prediction/expected_candidates.h"
#include "tests/support/hard_surfaces.h"
#include "tests/support/tiny_scenes.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace hipmap;

namespace {

PredictedPhotons predicted_of(std::vector<PredictedPhotons::At> places)
{
    return {std::move(places), 1, true};
}

Partition expect(const Scene& scene, const PredictedPhotons& predicted, std::uint32_t neighbours)
{
    Partition partition = build_partition(scene, {}).partition;
    expect_candidates(scene.mesh, predicted, most_photons_of_faces(predicted, scene.mesh),
                      {1000, neighbours}, partition);
    return partition;
}

} // namespace

TEST_CASE("expect_candidates: a face needs nearly 10 k photons of one side and kind",
          "[prediction]")
{
    const Scene scene = tiny::make_scene(tiny::quad());
    const auto photons_of_first = [&](double front, double back, double caustic) {
        return predicted_of({{{0, 0, PhotonKind::indirect}, front},
                             {{0, 0, PhotonKind::caustic}, caustic},
                             {{0, 1, PhotonKind::indirect}, back}});
    };
    using Flags = std::vector<std::uint8_t>;
    CHECK(expect(scene, photons_of_first(91, 0, 0), 10).candidate == Flags{1, 0});
    CHECK(expect(scene, photons_of_first(89, 89, 89), 10).candidate == Flags{0, 0});
    CHECK(expect(scene, photons_of_first(0, 91, 0), 10).candidate == Flags{1, 0});
    CHECK(expect(scene, photons_of_first(0, 0, 91), 10).candidate == Flags{1, 0});
    CHECK(expect(scene, photons_of_first(91, 0, 0), 11).candidate == Flags{0, 0});
    CHECK(expect(scene, predicted_of({}), 10).candidate == Flags{0, 0});
}

TEST_CASE("expect_candidates: a sliver becomes one once its photons are dense enough",
          "[prediction]")
{
    // Height h, one connected edge of length 1: searches begin if sqrt(h k / (2 pi N)) < h.
    const float height = 0.01f;
    const Scene scene = tiny::make_scene(tiny::make_mesh(
        {{0, 0, 0}, {1, 0, 0}, {0.5f, height, 0}, {0.5f, -1, 0}}, {{0, 1, 2}, {1, 0, 3}}));
    const double enough = 10 / (2 * M_PI * double{height});
    for (const auto& [factor, worth] : {std::pair(0.99, 0), std::pair(1.01, 1)}) {
        const PredictedPhotons predicted =
            predicted_of({{{0, 0, PhotonKind::indirect}, enough * factor}});
        CHECK(expect(scene, predicted, 10).candidate[0] == worth);
    }
}

TEST_CASE("expect_candidates: fewer than three traced photons say nothing", "[prediction]")
{
    const Scene scene = tiny::make_scene(tiny::quad());
    PredictedPhotons predicted = predicted_of({{{0, 0, PhotonKind::indirect}, 200}});
    predicted.each = 100;
    CHECK(expect(scene, predicted, 10).candidate[0] == 0);
    predicted.places[0].photons = 300;
    CHECK(expect(scene, predicted, 10).candidate[0] == 1);
}

TEST_CASE("expect_candidates: a group needs its photons on its faces together", "[prediction]")
{
    const Scene scene =
        tiny::make_scene(tiny::bent_grid(32, 32, [](glm::vec2 p) { return glm::vec3(p, 0); }));
    const Partition by_shape = build_partition(scene, {}).partition;
    REQUIRE(by_shape.group_count == 64);
    const std::uint32_t lit = by_shape.group_of_face[1000];
    std::vector<PredictedPhotons::At> places;
    for (FaceId face = 0; face < scene.mesh.face_count(); ++face)
        places.push_back(
            {{face, 0, PhotonKind::indirect}, by_shape.group_of_face[face] == lit ? 20.0 : 0.1});
    const Partition partition = expect(scene, predicted_of(places), 10);
    CHECK(partition.group_count == 1);
    for (FaceId face = 0; face < scene.mesh.face_count(); ++face) {
        const bool kept = by_shape.group_of_face[face] == lit;
        REQUIRE(partition.group_of_face[face] == (kept ? 0 : kNone));
        REQUIRE(partition.group_radius[face] == (kept ? by_shape.group_radius[face] : 0));
    }
    CHECK(std::ranges::count(partition.candidate, 1) == 0);
}

TEST_CASE("expect_candidates: without light candidates stay those by shape", "[prediction]")
{
    const Scene scene = tiny::make_scene(tiny::quad());
    PredictedPhotons dark;
    dark.is_lit = false;
    CHECK(expect(scene, dark, 10).candidate == build_partition(scene, {}).partition.candidate);
}
