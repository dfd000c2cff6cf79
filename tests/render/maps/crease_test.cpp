#include "common/math/sampling.h"
#include "common/rays/surface_point.h"
#include "tests/support/even_room_means.h"
#include "tests/support/tiny_scenes.h"

#include <catch2/catch.hpp>

#include <functional>

using namespace hipmap;

namespace {

/// Means of the estimates at points of the floor over sets of photons spread over it as `light`
/// says: relative density, at most 1.  What stands on the floor catches none.
std::vector<RunningMean> estimates_on_floor(const tiny::ReadyScene& ready,
                                            const std::vector<glm::vec3>& points,
                                            const std::function<float(const glm::vec3&)>& light)
{
    const TriangleMesh& mesh = ready.scene.mesh;
    const MapSurfaces surfaces(mesh, ready.partition);
    EstimateScratch scratch;
    std::vector<RunningMean> means(points.size());
    for (std::uint32_t set = 0; set < 100; ++set) {
        constexpr std::size_t kTrials = 20'000;
        std::vector<Photon> photons;
        for (std::size_t i = 0; i < kTrials; ++i) {
            RandomSequence random(1, RandomStream::photons, set, i);
            const FaceId face = random.next() < 0.5f ? 0 : 1;
            const SurfacePoint point = surface_point(mesh, face, sample_triangle(random.next2()));
            if (random.next() < light(point.position))
                photons.push_back({point.position, Rgb(1.0f / kTrials), {0, 1, 0}, face, 0});
        }
        const PhotonMaps maps = build_photon_maps(photons, ready.partition, {50});
        for (std::size_t i = 0; i < points.size(); ++i) {
            const glm::vec3& at = points[i];
            const FaceId face = at.z >= -at.x ? 0 : 1;
            means[i].add(estimate_irradiance(maps, surfaces, {at, {0, 1, 0}, face, 0}, scratch).y);
        }
    }
    return means;
}

} // namespace

TEST_CASE("estimate: even light is even up to edges and corners of a room", "[maps]")
{
    std::vector<glm::vec2> points;
    for (const float d : {0.0f, 0.004f, 0.02f, 0.04f, 0.06f, 0.1f, 0.16f, 0.24f})
        points.insert(points.end(), {{d, 0.5f}, {d, d}, {1 - d, d / 3}});
    for (const RunningMean& mean : tiny::means_in_even_room(points, {{50}, {}, 6000, 1500})) {
        CHECK(std::abs(mean.mean() - 1) < 0.01);
        CHECK(mean.standard_error() < 0.01 / kMostZ);
    }
}

TEST_CASE("estimate: light behind a wall that stands on one polygon adds nothing in front",
          "[maps]")
{
    Scene scene = tiny::make_scene(tiny::floor_at(0, 1));
    tiny::add(scene,
              tiny::make_mesh(
                  {{0.1f, 0, -0.5f}, {0.1f, 0, 0.5f}, {0.1f, 0.4f, 0.5f}, {0.1f, 0.4f, -0.5f}},
                  {{0, 1, 2}, {0, 2, 3}}),
              tiny::diffuse(Rgb(1)));
    const auto ready = tiny::ready(scene);
    std::vector<glm::vec3> points;
    for (const float d : {0.0001f, 0.003f, 0.02f, 0.05f})
        points.emplace_back(0.1f - d, 0, 0.13f);
    const auto dim = [](const glm::vec3& p) { return p.x < 0.1f ? 0.05f : 1.0f; };
    for (const RunningMean& lit : estimates_on_floor(*ready, points, dim))
        CHECK(std::abs(lit.mean() - 0.05) < 0.0005 + kMostZ * lit.standard_error());
    const auto dark = [](const glm::vec3& p) { return p.x < 0.1f ? 0.0f : 1.0f; };
    for (const RunningMean& lit : estimates_on_floor(*ready, points, dark))
        CHECK(lit.mean() == 0);
}

TEST_CASE("estimate: a box on or sunk into one polygon does not darken the floor round it",
          "[maps]")
{
    const float sunk = GENERATE(0.0f, 0.1f);
    Scene scene = tiny::make_scene(tiny::floor_at(0, 1));
    TriangleMesh box = tiny::cube();
    tiny::scale(box, 0.3f);
    tiny::move(box, {0.1f, 0.15f - sunk, 0.05f});
    tiny::add(scene, box, tiny::diffuse(Rgb(1)));
    const auto ready = tiny::ready(scene);
    const auto round = [](const glm::vec3& p) {
        return std::abs(p.x - 0.1f) < 0.15f && std::abs(p.z - 0.05f) < 0.15f ? 0.0f : 1.0f;
    };
    std::vector<glm::vec3> points;
    for (const float d : {0.0001f, 0.003f, 0.01f, 0.05f}) {
        points.emplace_back(-0.05f - d, 0, 0.07f);   // beside a side
        points.emplace_back(0.25f + d, 0, 0.2f + d); // beside a corner
    }
    for (const RunningMean& mean : estimates_on_floor(*ready, points, round))
        CHECK(std::abs(mean.mean() - 1) < 0.01 + kMostZ * mean.standard_error());
}
