#include "experiments/rivals/irradiance_cache.h"
#include "tests/experiments/rivals/rival_means.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

SurfacePoint point_at(const glm::vec3& position)
{
    SurfacePoint out;
    out.position = position;
    out.geometric_normal = out.shading_normal = {0, 0, 1};
    return out;
}

/// Light of a plane at height 1 whose radiance grows along x.
Rgb sloping_light(const Ray& ray, RandomSequence&, float& distance)
{
    distance = (1 - ray.origin.z) / ray.direction.z;
    return Rgb(2 + std::tanh((ray.origin + distance * ray.direction).x));
}

CacheRecord record_at(const glm::vec3& position, const glm::vec3& normal)
{
    RandomSequence random(1, RandomStream::photons, 0, 0);
    return sample_hemisphere(point_at(position), normal, 40'000, sloping_light, random);
}

} // namespace

TEST_CASE("irradiance cache: gradients are those of finite differences", "[rivals]")
{
    const CacheRecord middle = record_at({0.3f, 0, 0}, {0, 0, 1});
    const float step = 0.05f;
    const float ahead = record_at({0.3f + step, 0, 0}, {0, 0, 1}).irradiance.x;
    const float behind = record_at({0.3f - step, 0, 0}, {0, 0, 1}).irradiance.x;
    CHECK(middle.moved[0].x == Approx((ahead - behind) / (2 * step)).epsilon(0.05));
    CHECK(std::abs(middle.moved[0].y) < 0.03f);

    const glm::vec3 turned(std::sin(step), 0, std::cos(step));
    const glm::vec3 back(-turned.x, 0, turned.z);
    const float by_turning = (record_at({0.3f, 0, 0}, turned).irradiance.x -
                              record_at({0.3f, 0, 0}, back).irradiance.x) /
                             (2 * step);
    const glm::vec3 axis = glm::cross(glm::vec3(0, 0, 1), turned) / std::sin(step);
    CHECK(glm::dot(axis, middle.turned[0]) == Approx(by_turning).epsilon(0.1));
}

TEST_CASE("irradiance cache: a closed diffuse box has radiance one", "[rivals]")
{
    const auto ready = tiny::ready(tiny::emissive_box({0.3f, 0.5f, 0.7f}));
    RivalSettings settings = tiny::small_image(16);
    settings.directions = 64;
    const RunningMean found = tiny::means_of_seeds(*ready, settings, render_irradiance_cache);
    INFO(found.mean() << " with standard error " << found.standard_error());
    CHECK(std::abs(found.z_score(1)) < 3);
    CHECK(found.standard_error() < 0.005);
}

TEST_CASE("irradiance cache: is the path tracer without caustics", "[rivals]")
{
    const auto ready = tiny::ready(tiny::room());
    RivalSettings settings = tiny::small_image(16);
    settings.directions = 64;
    settings.tolerance = 0.2f;
    const RunningMean found = tiny::means_of_seeds(*ready, settings, render_irradiance_cache);
    const RunningMean paths = tiny::means_of_paths(*ready, settings, 150, {.caustic = false});
    INFO("found " << found.mean() << ", paths " << paths.mean());
    CHECK(std::abs(found.mean() / paths.mean() - 1) < 0.01);
    CHECK(found.mean() < 0.99 * tiny::means_of_paths(*ready, settings, 150).mean());
}
