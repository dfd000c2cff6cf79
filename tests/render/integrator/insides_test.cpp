#include "tests/render/integrator/all_integrators.h"
#include "tests/support/means_of_images.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>

#include <array>

using namespace hipmap;

namespace {

/// Transmittance and reflectance of layers that light may cross many times.
struct Onion {
    double through, back, back_from_behind;
};

/// Stokes 1862.
Onion behind(const Onion& a, const Onion& b)
{
    const double ring = 1 / (1 - a.back_from_behind * b.back);
    return {a.through * b.through * ring, a.back + a.through * a.through * b.back * ring,
            b.back_from_behind + b.through * b.through * a.back_from_behind * ring};
}

Onion interface(double before, double behind)
{
    const double r = (behind - before) / (behind + before);
    return {1 - r * r, r * r, r * r};
}

/// Slabs across y that share a part of their height: the lower one of index 1.3, the upper of 1.7.
Scene slabs(float priority_above, bool light_above)
{
    TriangleMesh slab = tiny::cube();
    tiny::scale(slab, 2);
    tiny::move(slab, {0, -0.6f, 0});
    Scene scene = tiny::make_scene(slab);
    scene.materials[0] = tiny::glass(1.3f);
    scene.materials[0].priority = 0.5f;
    tiny::move(slab, {0, 1.2f, 0});
    Material above = tiny::glass(1.7f);
    above.priority = priority_above;
    tiny::add(scene, slab, above);
    tiny::add(scene, tiny::floor_at(light_above ? 2.5f : -2.5f, light_above ? -3 : 3),
              tiny::emissive(Rgb(1)));
    scene.nested_dielectrics = true;
    scene.cameras[0] = tiny::square_view({0, 0, 0}, {0, light_above ? 1 : -1, 0}, 0.1f, 2);
    return scene;
}

/// Any balls of glass that lie in one another, with tint-free surfaces.
Scene bubbles(float roughness)
{
    Scene scene = tiny::make_scene(tiny::uv_sphere(24, 12));
    tiny::scale(scene.mesh, 0.5f);
    scene.materials[0] = tiny::glass(1.5f);
    for (const auto& [x, radius, ior, priority] :
         {std::array{0.3f, 0.4f, 1.33f, 1.0f}, std::array{-0.1f, 0.2f, 1.1f, 0.0f},
          std::array{-0.3f, 0.35f, 2.0f, -1.0f}}) {
        TriangleMesh ball = tiny::uv_sphere(24, 12);
        tiny::scale(ball, radius);
        tiny::move(ball, {x, 0.05f, 0});
        Material glass = tiny::glass(ior);
        glass.priority = priority;
        tiny::add(scene, ball, glass);
    }
    for (Material& material : scene.materials)
        material.roughness = roughness;
    scene.materials[1].dispersion = 2;
    scene.nested_dielectrics = true;
    scene.cameras[0] = tiny::square_view({0, 0, 0}, {0, -1, 0}, 0.9f, 2);
    return scene;
}

ImageOptions small_picture(Integrator integrator)
{
    ImageOptions options;
    options.integrator = integrator;
    options.width = options.height = 8;
    options.photons = 2000;
    return options;
}

} // namespace

TEST_CASE("nested dielectrics: light through overlapping slabs, either of which may win",
          "[integrator][media]")
{
    // The same three surfaces wherever the middle one is, from either side.
    const Onion all = behind(behind(interface(1, 1.3), interface(1.3, 1.7)), interface(1.7, 1));
    for (const float above : {0.0f, 1.0f})
        for (const bool light_above : {false, true}) {
            const auto ready = tiny::ready(slabs(above, light_above));
            for (const Integrator integrator : kAllIntegrators) {
                const RunningMean found = means_of(*ready, small_picture(integrator), 10);
                INFO(found.mean() << " +- " << found.standard_error() << ", priority " << above);
                CHECK(std::abs(found.mean() - all.through) <
                      kMostZ * found.standard_error() + 1e-5);
                CHECK(found.standard_error() < 0.01);
            }
        }
}

TEST_CASE("nested dielectrics: clear ones are not seen under an even sky", "[integrator][media]")
{
    for (const float roughness : {0.0f, 0.15f}) {
        Scene scene = bubbles(roughness);
        scene.environment = Rgb(1);
        const auto ready = tiny::ready(scene);
        for (const Integrator integrator : {Integrator::path, Integrator::progressive}) {
            const RunningMean found = means_of(*ready, small_picture(integrator), 10);
            INFO(found.mean() << " +- " << found.standard_error() << ", roughness " << roughness);
            // Facets that hide one another lose a little.
            const double kept = roughness > 0 ? 0.97 : 1 - 1e-4;
            CHECK(found.mean() < 1 + kMostZ * found.standard_error() + 1e-5);
            CHECK(found.mean() > kept - kMostZ * found.standard_error());
            CHECK(found.standard_error() < 0.01);
        }
    }
}

TEST_CASE("nested dielectrics: photons and paths agree", "[integrator][media]")
{
    Scene scene = tiny::box(tiny::diffuse({0.6f, 0.5f, 0.4f}));
    TriangleMesh ball = tiny::fine_ball(0.25);
    tiny::add(scene, ball, tiny::glass(1.5f));
    tiny::scale(ball, 0.7f);
    tiny::move(ball, {0.12f, 0, 0});
    Material water = tiny::glass(1.2f);
    water.absorption = {2, 1, 0.2f};
    water.priority = 1;
    tiny::add(scene, ball, water);
    tiny::add(scene, tiny::floor_at(0.45f, -0.4f), tiny::emissive(Rgb(6)));
    scene.nested_dielectrics = true;
    ImageOptions options = small_picture(Integrator::path);
    options.photons = 10000;
    check_agreement(*tiny::ready(scene), options, 16, 100, {.most_noise = 0.02});
}

TEST_CASE("subsurface: photons and paths agree on wax", "[integrator][media]")
{
    Scene scene = tiny::box(tiny::diffuse({0.6f, 0.5f, 0.4f}));
    TriangleMesh ball = tiny::fine_ball(0.25);
    tiny::move(ball, {0.05f, -0.1f, 0});
    Material wax = tiny::diffuse(Rgb(0.9f));
    wax.diffuse_transmission = 0.8f;
    wax.scattering = {12, 9, 6};
    wax.absorption = {0.1f, 0.5f, 1};
    tiny::add(scene, ball, wax);
    tiny::add(scene, tiny::floor_at(0.45f, -0.4f), tiny::emissive(Rgb(6)));
    ImageOptions options = small_picture(Integrator::path);
    options.photons = 10000;
    check_agreement(*tiny::ready(scene), options, 16, 50, {.most_noise = 0.02});
}

namespace {

/// A ball of radius 2 that neither refracts nor reflects, but absorbs.
Scene tinted_ball(const Rgb& absorption)
{
    Scene scene = tiny::make_scene(tiny::uv_sphere(192, 96));
    tiny::scale(scene.mesh, 2);
    scene.materials[0] = tiny::glass(1);
    scene.materials[0].absorption = absorption;
    return scene;
}

void check_image(const Scene& scene, double expected)
{
    const auto ready = tiny::ready(scene);
    for (const Integrator integrator : kAllIntegrators) {
        const RunningMean found = means_of(*ready, small_picture(integrator), 16);
        INFO(found.mean() << " +- " << found.standard_error() << ", expected " << expected
                          << ", integrator " << int(integrator));
        CHECK(std::abs(found.mean() - expected) <
              kMostZ * found.standard_error() + 2e-3 * expected);
        CHECK(found.standard_error() < 0.01 * expected);
    }
}

} // namespace

TEST_CASE("tinted glass: it absorbs from a camera on that stands in it", "[integrator][media]")
{
    const Rgb absorption{0.1f, 0.3f, 0.6f};
    Scene scene = tinted_ball(absorption);
    scene.environment = Rgb(1);
    scene.cameras[0].position = {0, 0, 0};
    check_image(scene, luminance(transmittance(absorption, 2)));
}

TEST_CASE("tinted glass: it absorbs between what lies in it", "[integrator][media]")
{
    const Rgb absorption{0.4f, 1, 2};
    Scene scene = tinted_ball(absorption);
    tiny::add(scene, tiny::floor_at(0, 0.4f), tiny::diffuse(Rgb(0.5f)));
    scene.cameras[0] = tiny::square_view({0, 0, 0}, {0, -1, 0}, 0.1f, 0.7f);
    const double distance = 0.8;
    const double left = luminance(transmittance(absorption, float(distance) + 0.7f));
    const auto light_left = [&](double irradiance) { return left * irradiance * 0.5 / M_PI; };
    Scene by_point = scene;
    ScenePointLight point;
    point.position = {distance * 0.6, distance * 0.8, 0};
    point.intensity = Rgb(1);
    by_point.lights = {point};
    check_image(by_point, light_left(0.8 / (distance * distance)));
    // An emissive face that looks down, so small that it lights as a point does.
    TriangleMesh lamp = tiny::floor_at(0, -0.04f);
    tiny::move(lamp, {distance * 0.6, distance * 0.8, 0});
    tiny::add(scene, lamp, tiny::emissive(Rgb(100)));
    check_image(scene, light_left(100 * 0.04 * 0.04 * 0.8 * 0.8 / (distance * distance)));
}
