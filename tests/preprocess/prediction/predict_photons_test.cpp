#include "preprocess/partition/build_partition.h"
#include "preprocess/prediction/predict_photons.h"
#include "preprocess/prediction/tree_rays.h"
#include "tests/support/copied_mesh.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>
#include <tbb/global_control.h>

#include <numeric>

using namespace hipmap;

namespace {

constexpr std::uint64_t kPaths = 1'000'000;

PredictedPhotons predict(const Scene& scene)
{
    return predict_photons(scene, build_partition(scene, {}).partition, {}, kPaths);
}

double sum_of(const PredictedPhotons& predicted, PhotonKind kind)
{
    double sum = 0;
    for (const auto& [place, photons] : predicted.places)
        sum += place.kind == kind ? photons : 0;
    return sum;
}

} // namespace

TEST_CASE("predict_photons: in a closed room light bounces as its albedo says", "[prediction]")
{
    for (const float albedo : {0.5f, 0.8f}) {
        Scene scene = tiny::furnace();
        scene.materials[0].base_color = Rgb(albedo);
        const PredictedPhotons predicted = predict(scene);
        CHECK(sum_of(predicted, PhotonKind::indirect) ==
              Approx(kPaths * albedo / (1 - albedo)).epsilon(0.03));
        CHECK(sum_of(predicted, PhotonKind::caustic) == 0);
        for (const auto& [place, photons] : predicted.places)
            REQUIRE(place.side == predicted.places[0].place.side); // inside
    }
}

TEST_CASE("predict_photons: an evenly lit surface holds photons by its area", "[prediction]")
{
    const Scene scene = tiny::furnace();
    std::vector<double> photons(2, 0.0), area(2, 0.0);
    for (const auto& [place, number] : predict(scene).places)
        photons[place.face % 2] += number;
    for (FaceId face = 0; face < scene.mesh.face_count(); ++face)
        area[face % 2] += face_area(scene.mesh, face);
    CHECK(photons[0] / photons[1] == Approx(area[0] / area[1]).epsilon(0.05));
}

TEST_CASE("predict_photons: none on glass and mirrors, caustics by both", "[prediction]")
{
    const Scene scene = tiny::room();
    const std::vector<MeanMaterial> materials = mean_materials(scene);
    const PredictedPhotons predicted = predict(scene);
    CHECK(sum_of(predicted, PhotonKind::caustic) > 1000);
    CHECK(sum_of(predicted, PhotonKind::indirect) > 1000);
    for (const auto& [place, photons] : predicted.places)
        CHECK(stores_photons(materials[scene.mesh.material_of_face[place.face]]));
}

TEST_CASE("predict_photons: every path of a light in a glass ball leaves a caustic", "[prediction]")
{
    TriangleMesh walls = tiny::uv_sphere(48, 24); // of radius 1
    tiny::turn_inside_out(walls);
    Scene scene = tiny::make_scene(walls);
    scene.materials[0] = tiny::diffuse(Rgb(0.5f));
    TriangleMesh ball = tiny::uv_sphere(48, 24);
    tiny::scale(ball, 0.2f);
    tiny::add(scene, ball, tiny::glass(1)); // which neither refracts nor reflects
    ScenePointLight light;
    light.intensity = Rgb(1);
    scene.lights.emplace_back(light);
    CHECK(sum_of(predict(scene), PhotonKind::caustic) == Approx(kPaths).epsilon(1e-3));
}

TEST_CASE("predict_photons: the same by one and four threads", "[prediction]")
{
    const Scene scene = tiny::room();
    const auto run = [&](std::size_t threads) {
        const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
        return predict(scene);
    };
    const PredictedPhotons one = run(1), four = run(4);
    REQUIRE(one.places.size() == four.places.size());
    for (std::size_t i = 0; i < one.places.size(); ++i) {
        CHECK(one.places[i].place == four.places[i].place);
        CHECK(one.places[i].photons == four.places[i].photons);
    }
}

TEST_CASE("predict_photons: copies hold what stored faces would", "[prediction]")
{
    Scene scene = tiny::make_scene(tiny::with_copies(
        tiny::floor_at(-0.2f, 2), tiny::uv_sphere(12, 8), {tiny::place_at({2.5, 0, 0}, 30)}));
    scene.materials[0] = tiny::diffuse(Rgb(0.7f));
    scene.environment = Rgb(1);
    Scene all = scene;
    all.mesh = tiny::stored(all.mesh);
    const PredictedPhotons stored = predict(all);
    PartitionResult copied = build_partition_of_copies(scene, {});
    REQUIRE(!scene.mesh.copies.empty());
    const PredictedPhotons predicted = predict_photons(scene, copied.partition, {}, kPaths);
    CHECK(predicted.places.back().place.face >= scene.mesh.face_count());
    CHECK(sum_of(predicted, PhotonKind::indirect) ==
          Approx(sum_of(stored, PhotonKind::indirect)).epsilon(0.01));
}

TEST_CASE("predict_photons: without light or paths nothing is predicted", "[prediction]")
{
    Scene dark = tiny::diffuse_floor();
    CHECK(!predict(dark).is_lit);
    CHECK(predict(dark).places.empty());
    dark.environment = Rgb(1);
    const Partition partition = build_partition(dark, {}).partition;
    CHECK(predict_photons(dark, partition, {}, 0).is_lit);
    CHECK(predict_photons(dark, partition, {}, 0).places.empty());
}

TEST_CASE("follow_light: in the tree of faces it goes as by Embree", "[prediction]")
{
    const Scene scene = tiny::room();
    const Partition partition = build_partition(scene, {}).partition;
    const std::vector<MeanMaterial> materials = mean_materials(scene);
    const MeanLights lights = collect_mean_lights(scene, materials);
    std::vector<FaceId> faces(scene.mesh.face_count());
    std::iota(faces.begin(), faces.end(), 0u);
    const FaceTree tree(scene.mesh, faces);
    const EmbreeScene embree(scene.mesh);
    const auto follow = [&](std::function<std::optional<RayHit>(const Ray&)> nearest) {
        const LightSpace space{scene.mesh, partition, materials, std::move(nearest)};
        std::vector<LeftPhoton> out;
        for (std::uint64_t i = 0; i < 5000; ++i) {
            RandomSequence random(1, RandomStream::photons, 0, i);
            const LightPoint point = draw_light_point(lights, double(i) / 5000, random);
            follow_light(space, draw_start(lights, point, random), PhotonKind::indirect, random,
                         out);
        }
        return out;
    };
    const auto by_tree =
        follow([&](const Ray& ray) { return nearest_in_tree(scene.mesh, tree, ray); });
    const auto by_embree = follow([&](const Ray& ray) { return embree.nearest(ray); });
    CHECK(by_tree.size() > 5000);
    CHECK(double(by_tree.size()) == Approx(double(by_embree.size())).epsilon(0.02));
}
