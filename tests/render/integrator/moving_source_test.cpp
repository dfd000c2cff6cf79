#include "common/partition/partition_in_motion.h"
#include "render/integrator/integrators.h"
#include "render/integrator/moving_source.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_scenes.h"

#include <catch2/catch.hpp>

#include <set>

namespace hipmap::tiny {

namespace {

constexpr float kRadiance = 3;
constexpr double kWay = 0.75;   ///< of the light's middle, about the origin
constexpr double kHalf = 0.125; ///< of the light's side

/// A light seen from above, after that share of its way along x.
Scene light_on_its_way(double share)
{
    TriangleMesh square = floor_at(0, static_cast<float>(2 * kHalf));
    move(square, {static_cast<float>((share - 0.5) * kWay), 0, 0});
    Scene scene = make_scene(square);
    scene.materials[0] = emissive(Rgb(kRadiance));
    scene.cameras[0] = square_view({0, 0, 0}, {0, -1, 0}, 1, 1);
    return scene;
}

RenderOptions small(Integrator integrator)
{
    RenderOptions options;
    options.integrator = integrator;
    options.width = options.height = 8;
    options.photons = 200;
    return options;
}

/// Share of the time that the light covers a line at x.
double time_covered(double x)
{
    const double from = std::max(x - kHalf, -kWay / 2), to = std::min(x + kHalf, kWay / 2);
    return std::max(0.0, to - from) / kWay;
}

} // namespace

TEST_CASE("the moments of a batch's passes are stratified, those of batches are not the same",
          "[motion]")
{
    std::set<double> firsts;
    for (std::uint64_t seed = 0; seed < 20; ++seed)
        for (std::uint64_t batch = 0; batch < kBatches; ++batch) {
            std::set<int> eighths;
            for (std::uint64_t i = 8; i < 16; ++i) {
                const double share = shutter_share(seed, i * kBatches + batch);
                REQUIRE(share >= 0);
                REQUIRE(share < 1);
                eighths.insert(static_cast<int>(8 * share));
            }
            CHECK(eighths.size() == 8);
            firsts.insert(shutter_share(seed, batch));
        }
    CHECK(firsts.size() == 20 * kBatches);
}

TEST_CASE("the mean over passes of a light that moves is the time for which it is seen", "[motion]")
{
    const auto still = ready(light_on_its_way(0.5));
    std::array<RunningMean, 8> columns;
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        RenderOptions options = small(Integrator::path);
        options.seed = seed;
        options.filter = PixelFilter::box;
        RenderStatistics statistics;
        const PassSource source =
            make_moving_source({*still->render, light_on_its_way}, options, statistics);
        std::array<double, 8> sums{};
        constexpr std::uint64_t kPasses = 32;
        for (std::uint64_t pass = 0; pass < kPasses; ++pass) {
            const Image image = source.render(pass, {}).images.radiance;
            for (std::size_t x = 0; x < 8; ++x)
                sums[x] += double{image.pixels[3 * 8 + x].x} / kPasses; // a row that it covers
        }
        for (std::size_t x = 0; x < 8; ++x)
            columns[x].add(sums[x]);
    }
    for (std::size_t x = 0; x < 8; ++x) {
        // Columns end where the covered time has its kinks, so it is linear in each.
        const double left = static_cast<double>(x) / 8 - 0.5;
        const double truth = kRadiance * (time_covered(left) + time_covered(left + 0.125)) / 2;
        INFO(x << ": " << columns[x].mean() << " of " << truth);
        CHECK(std::abs(columns[x].z_score(truth)) < kMostZ);
    }
}

TEST_CASE("a pass of the scene that a source was made of has the same bits at its moment",
          "[motion]")
{
    const auto still = ready(light_on_its_way(0.5));
    for (const Integrator integrator :
         {Integrator::direct, Integrator::path, Integrator::progressive}) {
        const RenderOptions options = small(integrator);
        RenderStatistics statistics;
        const PassSource plain = make_pass_source(*still->render, options, statistics);
        const PassSource moving = make_moving_source(
            {*still->render, [](double) { return light_on_its_way(0.5); }}, options, statistics);
        const PassImages a = plain.render(3, {}).images, b = moving.render(3, {}).images;
        CHECK(a.radiance.pixels == b.radiance.pixels);
        CHECK(a.narrow.pixels == b.narrow.pixels);
    }
}

TEST_CASE("a partition in motion drops what distances say of the maps that moved, and no more",
          "[motion]")
{
    Scene scene = make_scene(floor_at(-0.5f, 8));
    for (const float x : {-2.0f, 2.0f}) { // two cubes that stand on the floor
        TriangleMesh block = cube();
        move(block, {x, 0, 0});
        add(scene, block, scene.materials[0]);
    }
    for (FaceId face = 0; face < scene.mesh.face_count(); ++face)
        scene.mesh.object_of_face[face] = face < 2 ? 0 : face < 14 ? 1 : 2;
    const auto still = ready(scene);
    const Partition& then = still->partition;
    const auto on_floor = [&](const Partition& partition, bool left) {
        return std::count_if(
            partition.contacts.begin(), partition.contacts.end(), [&](const MapContact& contact) {
                return contact.map == then.map_of_face[0] && (contact.a.x < 0) == left;
            });
    };
    REQUIRE(on_floor(then, true) > 0);
    REQUIRE(on_floor(then, false) > 0);
    CHECK(partition_in_motion(then, scene.mesh, scene.mesh).contacts == then.contacts);

    TriangleMesh moved = scene.mesh;
    for (FaceId face = 2; face < 14; ++face)
        for (int c = 0; c < 3; ++c)
            moved.positions[moved.corners[face][c]].y =
                scene.mesh.positions[moved.corners[face][c]].y + 0.25f;
    const Partition now = partition_in_motion(then, scene.mesh, moved);
    CHECK(on_floor(now, true) == 0);
    CHECK(on_floor(now, false) == on_floor(then, false));
    CHECK(now.map_of_face == then.map_of_face);
    for (FaceId face = 0; face < scene.mesh.face_count(); ++face) {
        const bool in_motion = face >= 2 && face < 14;
        CHECK(now.candidate[face] == (in_motion ? 0 : then.candidate[face]));
        CHECK(now.self_distance[face] == (in_motion ? 0 : then.self_distance[face]));
        CHECK(now.group_of_face[face] == (in_motion ? kNone : then.group_of_face[face]));
    }
}

} // namespace hipmap::tiny
