#include "common/math/sampling.h"
#include "common/rays/surface_point.h"
#include "render/maps/radius_field.h"
#include "tests/support/brute_force.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_scenes.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

constexpr std::uint32_t kNeighbours = 20;

/// Side 0 of a unit square, more densely the smaller x is.
std::vector<Photon> photons_on_square(const TriangleMesh& mesh, std::size_t count,
                                      std::uint64_t seed, float exponent)
{
    std::vector<Photon> photons;
    while (photons.size() < count) {
        RandomSequence random(seed, RandomStream::photons, 0, photons.size());
        const auto face = static_cast<FaceId>(random.next() < 0.5f ? 0 : 1);
        glm::vec3 at = surface_point(mesh, face, sample_triangle(random.next2())).position;
        at.x = std::pow(at.x, exponent);
        photons.push_back({at, Rgb(1), {0, 0, 1}, face, 0});
    }
    return photons;
}

struct Field {
    std::unique_ptr<tiny::ReadyScene> ready = tiny::ready(tiny::make_scene(tiny::quad()));
    MapSurfaces surfaces{ready->scene.mesh, ready->partition};
    RadiusField field;

    explicit Field(const std::vector<Photon>& photons, const RadiusField::Rules& rules = {})
        : field(build_radius_field(build_photon_maps(photons, ready->partition, {kNeighbours}),
                                   surfaces, rules))
    {
    }

    float at(const glm::vec3& position, std::uint8_t side = 0) const
    {
        return radius_at(field, surfaces, {position, {0, 0, 1}, 0, side});
    }
};

} // namespace

TEST_CASE("radius field: where the k-th photon is, at most the even radius", "[maps]")
{
    const auto ready = tiny::ready(tiny::make_scene(tiny::quad()));
    const std::vector<Photon> photons = photons_on_square(ready->scene.mesh, 3000, 1, 3);
    const Field field(photons);
    std::vector<glm::vec3> points;
    for (const Photon& photon : photons)
        points.push_back(photon.position);
    const float even = filter_radius(1, kNeighbours, photons.size());
    std::size_t exact = 0, even_ones = 0;
    RunningMean ratio;
    for (const glm::vec3& point : points) {
        const auto nearest = brute_force::k_nearest(points, point, kNeighbours, 2,
                                                    [](std::uint32_t) { return true; });
        const float truth = std::min(even, std::sqrt(nearest.back().distance2));
        const float found = field.at(point);
        CHECK(found <= even * 1.00001f);
        CHECK(found > 0.447f * truth); // truth is at most rho + d, docs/photon_maps.md (10)
        ratio.add(double{found / truth});
        exact += std::abs(found - truth) <= 1e-6f * truth ? 1 : 0;
        even_ones += found >= even * 0.99999f ? 1 : 0;
    }
    CHECK(ratio.mean() > 1);
    CHECK(ratio.mean() < 1.1);
    CHECK(exact >= points.size() / 4); // those that have a radius of their own, at least
    CHECK(even_ones > 100);
    CHECK(even_ones < points.size() / 2);
}

TEST_CASE("radius field: k photons are within it on average", "[maps]")
{
    const auto ready = tiny::ready(tiny::make_scene(tiny::quad()));
    RunningMean photons_within;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const Field field(photons_on_square(ready->scene.mesh, 4000, seed, 1));
        const std::vector<Photon> others =
            photons_on_square(ready->scene.mesh, 4000, seed + 1000, 1);
        const glm::vec3 at{0.3f, 0.4f, 0};
        const float radius = field.at(at);
        photons_within.add(static_cast<double>(
            std::count_if(others.begin(), others.end(), [&](const Photon& photon) {
                return glm::distance(photon.position, at) <= radius;
            })));
    }
    CHECK(photons_within.mean() > 0.8 * kNeighbours); // cut at the even radius
    CHECK(photons_within.mean() < 1.1 * kNeighbours);
}

TEST_CASE("radius field: stays short of dense photons, but not of sparse ones", "[maps]")
{
    const auto ready = tiny::ready(tiny::make_scene(tiny::quad()));
    std::vector<Photon> photons = photons_on_square(ready->scene.mesh, 4000, 4, 1);
    for (Photon& photon : photons) // a corner of a hundredth of the area
        photon.position *= 0.1f;
    const Field dense(photons);
    for (const float way : {0.02f, 0.05f})
        CHECK(dense.at({0.1f + way, 0.05f, 0}) < way);
    std::vector<Photon> sparse = photons_on_square(ready->scene.mesh, 200, 5, 1);
    std::erase_if(sparse, [](const Photon& photon) { return photon.position.x > 0.5f; });
    CHECK(Field(sparse).at({0.6f, 0.5f, 0}) > 0.1f);
}

TEST_CASE("radius field: sharp ones are narrowed by density and by how far photons lie to one side",
          "[maps]")
{
    const auto ready = tiny::ready(tiny::make_scene(tiny::quad()));
    const std::vector<Photon> photons = photons_on_square(ready->scene.mesh, 3000, 1, 3);
    const Field wide(photons), sharp(photons, {.sharp = true});
    const RadiusField::Map& of_wide = wide.field.maps[0];
    const float even = filter_radius(1, kNeighbours, photons.size());
    std::vector<glm::vec3> points;
    for (const Photon& photon : photons)
        points.push_back(photon.position);
    REQUIRE(of_wide.radius.size() >= photons.size() / 4);
    std::size_t at_edges = 0;
    for (std::uint32_t slot = 0; slot < of_wide.radius.size(); ++slot) {
        const glm::vec3 at = of_wide.tree.position(slot);
        const float radius = of_wide.radius[slot];
        double expected = radius * std::sqrt(std::max(radius / even, 0.25f)); // (11)
        const auto nearest =
            brute_force::k_nearest(points, at, kNeighbours, 2, [](std::uint32_t) { return true; });
        if (nearest.back().distance2 < even * even) { // docs/photon_maps.md (12)
            glm::dvec3 mean(0);
            for (const auto& one : nearest)
                mean += glm::dvec3(points[one.photon] - at) / double{kNeighbours};
            const double m2 = glm::dot(mean, mean) / double{nearest.back().distance2};
            const double edge = std::clamp((m2 - 0.5 / kNeighbours) / 0.09, 0.0, 1.0);
            expected *= 1 - 0.7 * edge;
            at_edges += edge > 0.5 ? 1 : 0;
        }
        CHECK(sharp.field.maps[0].radius[slot] == Approx(expected).epsilon(1e-4));
    }
    CHECK(at_edges > 20);
}

TEST_CASE("radius field: sharp ones are narrowed at an edge of light, and not in even light",
          "[maps]")
{
    const auto ready = tiny::ready(tiny::make_scene(tiny::quad()));
    std::vector<Photon> photons = photons_on_square(ready->scene.mesh, 60'000, 6, 1);
    std::erase_if(photons, [](const Photon& photon) { return photon.position.x > 0.25f; });
    const Field wide(photons), sharp(photons, {.sharp = true});
    const RadiusField::Map& of_wide = wide.field.maps[0];
    const float even = filter_radius(1, kNeighbours, photons.size());
    RunningMean at_edge, in_light;
    for (std::uint32_t slot = 0; slot < of_wide.radius.size(); ++slot) {
        const glm::vec3 at = of_wide.tree.position(slot);
        const float radius = of_wide.radius[slot];
        const double part = sharp.field.maps[0].radius[slot] / (radius * std::sqrt(radius / even));
        if (std::min({at.x, at.y, 1 - at.y}) < 2 * radius) // the border of the map
            continue;
        if (at.x > 0.25f - 0.1f * radius)
            at_edge.add(part);
        else if (at.x < 0.25f - 2 * radius)
            in_light.add(part);
    }
    REQUIRE(at_edge.count() > 9);
    CHECK(at_edge.mean() < 0.5);
    CHECK(at_edge.mean() >= 0.3);
    CHECK(in_light.mean() > 0.93); // it may look like an edge by chance
    CHECK(in_light.mean() < 1.01);
}

TEST_CASE("radius field: the same by every instruction set, and never zero", "[maps]")
{
    const auto ready = tiny::ready(tiny::make_scene(tiny::quad()));
    const Field field(photons_on_square(ready->scene.mesh, 500, 2, 3));
    for (std::uint64_t i = 0; i < 500; ++i) {
        RandomSequence random(3, RandomStream::eye_paths, 0, i);
        const glm::vec3 point(random.next2(), 0);
        const float radius = field.at(point);
        for (const char* target : simd_targets()) {
            REQUIRE(use_simd_target(target));
            CHECK(radius == field.at(point));
        }
        CHECK(radius > 0);
    }
    const float nan = std::numeric_limits<float>::quiet_NaN();
    CHECK(field.at(glm::vec3(nan)) == filter_radius(1, kNeighbours, 500));
}

TEST_CASE("radius field: without photons, as for one", "[maps]")
{
    const Field none({});
    CHECK(none.at({0.5f, 0.5f, 0}) == filter_radius(1, kNeighbours, 1));
    const Field front(photons_on_square(none.ready->scene.mesh, 100, 1, 1));
    CHECK(front.at({0.5f, 0.5f, 0}, 1) == filter_radius(1, kNeighbours, 1));
}
