#include "common/math/random.h"
#include "common/math/sampling.h"
#include "render/media/optical_depth.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

/// In the cube from -1 to 1 along each axis.
PlacedDensity placed(const DensityGrid& grid)
{
    return {&grid, glm::vec3(-1), 0.5f * glm::vec3(grid.nodes - 1u)};
}

template <typename Density>
DensityGrid grid_of(const glm::uvec3& nodes, const Density& density)
{
    DensityGrid out{nodes, {}};
    for (unsigned z = 0; z < nodes.z; ++z)
        for (unsigned y = 0; y < nodes.y; ++y)
            for (unsigned x = 0; x < nodes.x; ++x)
                out.values.push_back(
                    density(2.0f * glm::vec3(x, y, z) / glm::vec3(nodes - 1u) - 1.0f));
    return out;
}

/// Through the cube and beyond it on both sides; every third along an axis.
Ray ray_through(std::uint64_t number)
{
    RandomSequence random(11, RandomStream::pictures, 0, number);
    Ray out;
    out.direction = sample_sphere(random.next2());
    if (number % 3 == 0) {
        out.direction = glm::vec3(0);
        out.direction[number % 9 / 3] = number % 2 == 0 ? 1.0f : -1.0f;
    }
    const glm::vec3 middle = 1.8f * (glm::vec3(random.next2(), random.next()) - 0.5f);
    out.origin = middle - 3.0f * out.direction;
    out.near = 0.5f;
    out.far = 5.5f;
    return out;
}

} // namespace

TEST_CASE("optical depth: of a linear density it is the length times the middle's", "[media]")
{
    const auto linear = [](const glm::vec3& p) { return 3 + p.x - 0.5f * p.y + p.z; };
    for (const glm::uvec3& nodes : {glm::uvec3(2), glm::uvec3(5, 2, 9)}) {
        const DensityGrid grid = grid_of(nodes, linear);
        for (std::uint64_t i = 0; i < 200; ++i) {
            Ray ray = ray_through(i);
            ray.near = 2.9f; // within the cube
            ray.far = 3.1f;
            const glm::vec3 middle = ray.origin + 3.0f * ray.direction;
            CHECK(total_optical_depth(placed(grid), ray) ==
                  Approx(0.2 * linear(middle)).epsilon(1e-5));
        }
    }
}

TEST_CASE("optical depth: of any grid it is the sum of many small steps", "[media]")
{
    std::uint64_t seed = 0;
    const DensityGrid grid = grid_of({4, 6, 3}, [&](const glm::vec3&) {
        RandomSequence random(5, RandomStream::pictures, 0, seed++);
        const float value = random.next();
        return value < 0.3f ? 0.0f : 4 * value;
    });
    const PlacedDensity density = placed(grid);
    for (std::uint64_t i = 0; i < 60; ++i) {
        const Ray ray = ray_through(i);
        const OpticalDepth optical_depth = optical_depth_along(density, ray);
        CHECK(optical_depth.total == total_optical_depth(density, ray));
        constexpr int kSteps = 4000;
        double sum = 0;
        for (int step = 0; step < kSteps; ++step) {
            const double size = (double{ray.far} - ray.near) / kSteps;
            const double at = ray.near + (step + 0.5) * size;
            const glm::dvec3 p = (glm::dvec3(ray.origin) + at * glm::dvec3(ray.direction) + 1.0) *
                                 0.5 * glm::dvec3(grid.nodes - 1u);
            double value = 0; // each node's share, by its distance along the axes
            for (std::size_t n = 0; n < grid.values.size(); ++n) {
                const glm::dvec3 node(n % 4, n / 4 % 6, n / 24);
                const glm::dvec3 share = glm::max(1.0 - glm::abs(p - node), glm::dvec3(0));
                value += share.x * share.y * share.z * grid.values[n];
            }
            const bool within = glm::all(glm::greaterThanEqual(p, glm::dvec3(0))) &&
                                glm::all(glm::lessThanEqual(p, glm::dvec3(grid.nodes - 1u)));
            sum += within ? value * size : 0;
            if (step % 500 == 0) {
                const float distance = static_cast<float>(at - 0.5 * size);
                CHECK(optical_depth_to(optical_depth, distance) ==
                      Approx(sum - (within ? value * size : 0)).margin(0.01));
            }
        }
        CHECK(optical_depth.total == Approx(sum).margin(0.01));
    }
}

TEST_CASE("optical depth: the distance at which it has a size has that column", "[media]")
{
    const DensityGrid grid = grid_of({5, 5, 5}, [](const glm::vec3& p) {
        return std::max(0.0f, 1 - glm::length(p)) * 30; // zero in the corners
    });
    const PlacedDensity density = placed(grid), even;
    for (std::uint64_t i = 0; i < 200; ++i) {
        const Ray ray = ray_through(i);
        const OpticalDepth optical_depth = optical_depth_along(density, ray);
        for (const float share : {0.0f, 0.1f, 0.5f, 0.999f}) {
            const float distance = distance_at(optical_depth, share * optical_depth.total);
            CHECK(distance >= ray.near);
            CHECK(distance <= ray.far);
            CHECK(optical_depth_to(optical_depth, distance) ==
                  Approx(share * optical_depth.total).margin(2e-5 * optical_depth.total + 1e-5));
        }
        CHECK(distance_at(optical_depth, 1.1f * optical_depth.total + 1) == ray.far);
        const OpticalDepth plain = optical_depth_along(even, ray);
        CHECK(plain.total == ray.far - ray.near);
        CHECK(distance_at(plain, 1.5f) == ray.near + 1.5f);
        CHECK(optical_depth_to(plain, 2) == 2 - ray.near);
    }
}

TEST_CASE("optical depth: nothing is there beside the box", "[media]")
{
    const DensityGrid grid = grid_of({2, 2, 2}, [](const glm::vec3&) { return 1.0f; });
    Ray ray;
    ray.origin = {0, 1.5f, -3};
    ray.near = 0;
    ray.far = 9;
    CHECK(total_optical_depth(placed(grid), ray) == 0);
    CHECK(optical_depth_to(optical_depth_along(placed(grid), ray), 4) == 0);
    ray.origin.y = 0;
    CHECK(total_optical_depth(placed(grid), ray) == Approx(2));
    ray.far = 1;
    CHECK(total_optical_depth(placed(grid), ray) == 0);
}
