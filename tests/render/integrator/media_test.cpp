#include "common/math/random.h"
#include "render/integrator/integrators.h"
#include "tests/render/integrator/all_integrators.h"
#include "tests/support/mean_luminance.h"
#include "tests/support/render_image.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_media.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

/// Densities from 0 to 2, anyhow.
std::shared_ptr<const DensityGrid> any_density()
{
    auto out = std::make_shared<DensityGrid>();
    out->nodes = {3, 4, 5};
    for (std::uint64_t i = 0; i < 60; ++i)
        out->values.push_back(2 * RandomSequence(6, RandomStream::pictures, 0, i).next());
    return out;
}

/// 0, 1 and 4 at the bottom, half way up and at the top: 1.5 all the way.
std::shared_ptr<const DensityGrid> denser_above()
{
    auto out = std::make_shared<DensityGrid>();
    out->nodes = {2, 3, 2};
    out->values = {0, 0, 1, 1, 4, 4, 0, 0, 1, 1, 4, 4};
    return out;
}

/// Mean of the channels of small pictures, by passes that do not depend on each other.
RunningMean measure(const Scene& scene, Integrator integrator, std::uint64_t passes = 10,
                    std::uint32_t samples = 2)
{
    const auto ready = tiny::ready(scene);
    RenderOptions options;
    options.integrator = integrator;
    options.width = options.height = 12;
    options.photons = 4000;
    options.samples = samples;
    RenderStatistics ignored;
    const PassSource source = make_pass_source(*ready->render, options, ignored);
    RunningMean out;
    for (std::uint64_t pass = 0; pass < passes; ++pass)
        out.add(mean_of(source.render(pass, {}).images.radiance));
    return out;
}

void check(const RunningMean& found, double expected, double most_noise)
{
    INFO(found.mean() << " +- " << found.standard_error() << ", expected " << expected);
    // Where nothing is drawn the rounding of floats is the error.
    const double error = std::hypot(found.standard_error(), 0x1p-19 * expected);
    CHECK(std::abs(found.mean() - expected) < kMostZ * error);
    CHECK(error < most_noise * expected);
}

void check_agreement(const Scene& scene)
{
    const RunningMean path = measure(scene, Integrator::path, 32, 8);
    for (const Integrator integrator : {Integrator::progressive, Integrator::direct}) {
        const RunningMean maps = measure(scene, integrator, 24);
        const double noise = std::hypot(maps.standard_error(), path.standard_error());
        INFO(int(integrator) << ": " << maps.mean() << " +- " << maps.standard_error() << ", path "
                             << path.mean() << " +- " << path.standard_error());
        // Faces that bend within a disc leave a bias below 1 part in 100.
        CHECK(std::abs(maps.mean() - path.mean()) < 0.01 * path.mean() + kMostZ * noise);
        CHECK(noise < 0.015 * path.mean());
    }
}

} // namespace

TEST_CASE("media: light is absorbed as Beer and Lambert say", "[integrator][media]")
{
    Medium medium;
    medium.absorption = {0.5f, 1, 4};
    Scene scene = tiny::cube_of(medium);
    tiny::add(scene, tiny::floor_at(-0.6f, 3), tiny::emissive(Rgb(2)));
    double expected = 0;
    for (int c = 0; c < 3; ++c)
        expected += 2 * std::exp(-double{medium.absorption[c]}) / 3;
    for (const Integrator integrator : kAllIntegrators)
        check(measure(scene, integrator, 2), expected, 1e-4);
    medium.density = denser_above();
    scene.materials[0] = tiny::fog(medium);
    expected = 0;
    for (int c = 0; c < 3; ++c)
        expected += 2 * std::exp(-1.5 * double{medium.absorption[c]}) / 3;
    for (const Integrator integrator : kAllIntegrators)
        check(measure(scene, integrator, 2), expected, 1e-4);
}

TEST_CASE("media: an emissive slab sends e/a (1 - exp(-a d))", "[integrator][media]")
{
    Medium medium;
    medium.absorption = Rgb(2);
    medium.emission = Rgb(3);
    for (const Integrator integrator : kAllIntegrators)
        check(measure(tiny::cube_of(medium), integrator, 2), 1.5 * (1 - std::exp(-2.0)), 1e-4);
    medium.density = denser_above();
    for (const Integrator integrator : kAllIntegrators)
        check(measure(tiny::cube_of(medium), integrator, 2), 1.5 * (1 - std::exp(-3.0)), 1e-4);
}

TEST_CASE("media: a slab thinner than the camera's clipping distance is as any other",
          "[integrator][media]")
{
    Medium medium;
    medium.absorption = Rgb(2);
    medium.emission = Rgb(3);
    Scene scene = tiny::cube_of(medium);
    scene.cameras[0].near_clip = 1.2f;
    for (const Integrator integrator : kAllIntegrators)
        check(measure(scene, integrator, 2), 1.5 * (1 - std::exp(-2.0)), 1e-4);
}

TEST_CASE("media: with an albedo of one nothing is seen under an even sky", "[integrator][media]")
{
    Medium medium;
    medium.scattering = {1, 3, 9};
    for (const PhaseFunction& phase :
         {PhaseFunction{}, PhaseFunction{PhaseKind::henyey_greenstein, 0.7f},
          PhaseFunction{PhaseKind::schlick, -0.4f}}) {
        medium.phase = phase;
        Scene scene = tiny::cube_of(medium);
        scene.environment = Rgb(1);
        for (const Integrator integrator : kAllIntegrators)
            check(measure(scene, integrator), 1, 0.03);
    }
    medium.density = any_density();
    Scene smoke = tiny::cube_of(medium);
    smoke.environment = Rgb(1);
    for (const Integrator integrator : kAllIntegrators)
        check(measure(smoke, integrator), 1, 0.03);
    Scene milk = tiny::cube_of(medium); // within glass
    milk.environment = Rgb(1);
    milk.materials[0] = tiny::glass(1.5f);
    milk.materials[0].scattering = medium.scattering;
    for (const Integrator integrator : kAllIntegrators)
        check(measure(milk, integrator), 1, 0.03);
}

TEST_CASE("media: fog that absorbs nothing changes nothing in a furnace", "[integrator][media]")
{
    Scene scene = tiny::furnace();
    scene.around.scattering = {1, 2, 4};
    for (const Integrator integrator : kAllIntegrators)
        check(measure(scene, integrator), 1, 0.02);
}

TEST_CASE("media: light that is scattered once", "[integrator][media]")
{
    Medium medium; // so thin that what is scattered twice is less than the noise
    medium.absorption = Rgb(1);
    medium.scattering = Rgb(1e-3f);
    medium.phase = {PhaseKind::henyey_greenstein, 0.5f};
    Scene scene = tiny::cube_of(medium, 0.2f);
    ScenePointLight light;
    light.position = {0.4f, 0, 0};
    light.intensity = Rgb(1);
    scene.lights = {light};
    double expected = 0;
    constexpr int kSteps = 40;
    for (int i = 0; i < kSteps * kSteps * kSteps; ++i) {
        const auto middle = [](int cell, double low, double high) {
            return low + (high - low) * (cell + 0.5) / kSteps;
        };
        const glm::dvec3 p(middle(i % kSteps, -0.1, 0.1), middle(i / kSteps / kSteps, -0.5, 0.5),
                           middle(i / kSteps % kSteps, -0.1, 0.1));
        const glm::dvec3 way = p - glm::dvec3(light.position);
        const double distance = glm::length(way), g = 0.5, t = 1.001;
        const double cosine = way.y / distance; // from the light, and up to the eye
        const double phase = (1 - g * g) / (4 * M_PI * std::pow(1 + g * g - 2 * g * cosine, 1.5));
        expected += 1e-3 * phase * std::exp(-t * (distance + 0.5 - p.y)) / (distance * distance) /
                    (kSteps * kSteps * kSteps);
    }
    check(measure(scene, Integrator::path, 64), expected, 0.02);
}

TEST_CASE("media: integrators agree on fog, milk and haze under a light", "[integrator][media]")
{
    Scene scene = tiny::box(tiny::diffuse({0.6f, 0.5f, 0.4f}));
    TriangleMesh shape = tiny::cube();
    tiny::scale(shape, 0.35f);
    tiny::move(shape, {-0.22f, -0.25f, 0});
    Medium medium;
    medium.scattering = {4, 8, 12};
    medium.absorption = {1, 0.5f, 3};
    medium.phase = {PhaseKind::henyey_greenstein, 0.5f};
    tiny::add(scene, shape, tiny::fog(medium));
    shape = tiny::fine_ball(0.18);
    tiny::move(shape, {0.22f, -0.25f, 0});
    Material milk = tiny::glass(1.4f);
    milk.scattering = {15, 12, 9};
    milk.absorption = {0.1f, 0.5f, 1};
    tiny::add(scene, shape, milk);
    scene.around.scattering = Rgb(0.4f);
    TriangleMesh light = tiny::floor_at(0.45f, -0.3f);
    tiny::add(scene, light, tiny::emissive(Rgb(10)));
    check_agreement(scene);
}

TEST_CASE("media: integrators agree on a room that an emissive medium lights",
          "[integrator][media]")
{
    Scene scene = tiny::box(tiny::diffuse({0.6f, 0.5f, 0.4f}));
    TriangleMesh cube = tiny::cube();
    tiny::scale(cube, 0.4f);
    Medium medium;
    medium.emission = {3, 2, 1};
    medium.absorption = {1, 2, 3};
    tiny::add(scene, cube, tiny::fog(medium));
    check_agreement(scene);
}

TEST_CASE("media: integrators agree on smoke that is denser here than there", "[integrator][media]")
{
    Scene scene = tiny::box(tiny::diffuse({0.6f, 0.5f, 0.4f}));
    TriangleMesh cube = tiny::cube();
    tiny::scale(cube, 0.6f);
    Medium medium;
    medium.scattering = {8, 6, 4};
    medium.absorption = {1, 2, 3};
    medium.emission = {0, 0.5f, 1};
    medium.density = any_density();
    tiny::add(scene, cube, tiny::fog(medium));
    scene.around.scattering = Rgb(0.4f);
    scene.around.density = any_density();
    TriangleMesh light = tiny::floor_at(0.45f, -0.3f);
    tiny::add(scene, light, tiny::emissive(Rgb(10)));
    check_agreement(scene);
}
