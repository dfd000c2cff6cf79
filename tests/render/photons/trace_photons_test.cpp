#include "common/math/sampling.h"
#include "render/photons/trace_photons.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_scenes.h"

#include <catch2/catch.hpp>
#include <tbb/global_control.h>

#include <array>
#include <cstring>

using namespace hipmap;

namespace {

/// A box with its front open: diffuse walls, a glass and a mirror ball, a light and a point light.
Scene open_room()
{
    TriangleMesh room = tiny::open_box();
    tiny::turn_inside_out(room);
    Scene scene = tiny::make_scene(room);
    scene.materials[0] = tiny::diffuse({0.7f, 0.5f, 0.3f});
    TriangleMesh ball = tiny::uv_sphere(24, 12);
    tiny::scale(ball, 0.15f);
    tiny::move(ball, {-0.2f, -0.2f, 0});
    Material tinted = tiny::glass(1.5f);
    tinted.absorption = {0.5f, 1.0f, 2.0f};
    tiny::add(scene, ball, tinted);
    tiny::move(ball, {0.4f, 0, 0});
    tiny::add(scene, ball, tiny::mirror({0.9f, 0.8f, 0.7f}));
    TriangleMesh light = tiny::floor_at(0.4f, -0.3f);
    tiny::add(scene, light, tiny::emissive({3, 4, 5}));
    ScenePointLight point;
    point.position = {0.1f, 0.1f, 0.2f};
    point.intensity = {1, 2, 1};
    scene.lights = {point};
    return scene;
}

/// The same with a rough coat on the walls, a frosted glass ball and one of brushed metal.
Scene glossy_room()
{
    Scene scene = open_room();
    scene.materials[0].specular = 1;
    scene.materials[0].roughness = 0.6f;
    scene.materials[1].roughness = 0.3f;
    scene.materials[2].roughness = 0.4f;
    return scene;
}

bool same_bytes(const std::vector<Photon>& a, const std::vector<Photon>& b)
{
    if (a.size() != b.size())
        return false;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (a[i].position != b[i].position || a[i].power != b[i].power ||
            a[i].direction != b[i].direction || a[i].face != b[i].face || a[i].side != b[i].side)
            return false;
    return true;
}

} // namespace

TEST_CASE("trace photons: emitted power is absorbed or escapes", "[photons]")
{
    const auto ready = tiny::ready(GENERATE(false, true) ? glossy_room() : open_room());
    for (int channel = 0; channel < 3; ++channel) {
        RunningMean lost;
        double emitted = 0;
        for (std::uint64_t pass = 0; pass < 64; ++pass) {
            const TracedPhotons traced = trace_photons(*ready->render, {4096, 1, pass, true});
            emitted = traced.power.emitted[channel];
            lost.add(traced.power.absorbed[channel] + traced.power.escaped[channel]);
            CHECK(traced.dropped == 0);
            CHECK(traced.cut == 0);
        }
        CHECK(std::abs(lost.z_score(emitted)) < kMostZ);
        CHECK(lost.standard_error() < 0.01 * emitted);
    }
}

TEST_CASE("trace photons: light that glass of a high index catches comes out again", "[photons]")
{
    Scene scene = open_room();
    scene.materials[1] = tiny::glass(10); // which does not absorb
    const auto ready = tiny::ready(std::move(scene));
    RunningMean lost;
    double emitted = 0;
    for (std::uint64_t pass = 0; pass < 64; ++pass) {
        const TracedPhotons traced = trace_photons(*ready->render, {4096, 1, pass, true});
        emitted = traced.power.emitted.g;
        lost.add(traced.power.absorbed.g + traced.power.escaped.g);
        CHECK(traced.cut == 0);
    }
    CHECK(std::abs(lost.z_score(emitted)) < kMostZ);
    CHECK(lost.standard_error() < 0.01 * emitted);
}

TEST_CASE("trace photons: 1, 2 and 7 threads trace the same photons", "[photons]")
{
    const auto ready = tiny::ready(open_room());
    const PhotonOptions options{20000, 3, 0, true};
    const auto trace_with = [&](std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        return trace_photons(*ready->render, options);
    };
    const TracedPhotons one = trace_with(1);
    REQUIRE(one.global.size() > 10000);
    REQUIRE(one.caustic.size() > 100);
    for (const std::size_t threads : {2, 7}) {
        const TracedPhotons many = trace_with(threads);
        CHECK(same_bytes(one.global, many.global));
        CHECK(same_bytes(one.caustic, many.caustic));
        CHECK(one.power.absorbed == many.power.absorbed);
    }
}

TEST_CASE("trace photons: direct photons carry the irradiance of a point light", "[photons]")
{
    // A point light at height h over the middle of a square: flux through it in closed form.
    Scene scene = tiny::make_scene(tiny::floor_at(0, 1));
    scene.materials[0] = tiny::diffuse(Rgb(0.5f));
    ScenePointLight light;
    light.position = {0, 0.25f, 0};
    light.intensity = Rgb(1);
    scene.lights = {light};
    const auto ready = tiny::ready(scene);
    // Solid angle of a square of half side a seen from height h.
    const double a = 0.5, h = 0.25;
    const double truth = 4 * std::asin(a * a / (a * a + h * h));
    RunningMean flux;
    for (std::uint64_t pass = 0; pass < 50; ++pass) {
        const TracedPhotons traced = trace_photons(*ready->render, {2000, 1, pass, true});
        double sum = 0;
        for (const Photon& photon : traced.global)
            sum += photon.power.x;
        flux.add(sum);
        CHECK(traced.caustic.empty());
    }
    CHECK(std::abs(flux.z_score(truth)) < kMostZ);
}

TEST_CASE("trace photons: classes go to their maps, sides are told apart", "[photons]")
{
    const auto ready = tiny::ready(open_room());
    const TracedPhotons with = trace_photons(*ready->render, {20000, 1, 0, true});
    const TracedPhotons without = trace_photons(*ready->render, {20000, 1, 0, false});
    CHECK(with.global.size() > without.global.size());
    CHECK(with.caustic.size() == without.caustic.size());
    const std::vector<Bsdf>& bsdfs = ready->render->bsdfs;
    for (const Photon& photon : with.global) {
        CHECK(bsdfs[ready->scene.mesh.material_of_face[photon.face]].gathers);
        const glm::dvec3 normal = scaled_normal(ready->scene.mesh, photon.face);
        const bool front = glm::dot(glm::dvec3(photon.direction), normal) > 0;
        const bool flipped = ready->partition.flipped[photon.face] != 0;
        CHECK(photon.side == (front == flipped ? 1 : 0));
    }
    CHECK(trace_photons(*ready->render, {0, 1, 0, true}).global.empty());
}

TEST_CASE("trace photons: power is stored without the coat's share where photons are weighed",
          "[photons]")
{
    Scene scene = tiny::make_scene(tiny::floor_at(0, 1));
    scene.materials[0] = tiny::diffuse(Rgb(0.5f));
    scene.materials[0].specular = 1;
    ScenePointLight light;
    light.position = {0, 0.25f, 0};
    light.intensity = Rgb(1);
    scene.lights = {light};
    for (const float roughness : {0.2f, 0.5f}) {
        scene.materials[0].roughness = roughness;
        const auto ready = tiny::ready(scene);
        CHECK(ready->render->directional == (roughness > kFollowedRoughness));
        const TracedPhotons traced = trace_photons(*ready->render, {1000, 1, 0, true});
        REQUIRE(!traced.global.empty());
        for (const Photon& photon : traced.global) {
            const float through = ready->render->directional
                                      ? 1
                                      : transmitted_by(ready->render->bsdfs[0].layers,
                                                       Depth::diffuse, photon.direction.y)
                                            .x;
            CHECK(photon.power.x == Approx(4 * kPi / 1000 * through));
        }
    }
}

TEST_CASE("trace photons: a closed glass ball absorbs by Beer and Lambert", "[photons]")
{
    // One narrow beam straight through the middle of a slab: two crossings, one thickness.
    TriangleMesh slab = tiny::cube();
    for (glm::vec3& p : slab.positions)
        p.y *= 0.5f;
    Scene scene = tiny::make_scene(slab);
    scene.materials[0] = tiny::glass(1.0f); // no reflection: only absorption is left
    scene.materials[0].absorption = {1, 2, 4};
    SceneSunLight sun;
    sun.direction = {0, -1, 0};
    sun.irradiance = Rgb(1);
    scene.lights = {sun};
    const auto ready = tiny::ready(scene);
    const TracedPhotons traced = trace_photons(*ready->render, {100000, 1, 0, true});
    const double radius2 =
        std::pow(std::get<SunLight>(ready->render->lights.lights[0]).scene.radius, 2);
    for (int c = 0; c < 3; ++c) {
        // The sun's disc is larger than the slab: what misses it escapes whole.
        const double absorbed = 1 - std::exp(-0.5 * scene.materials[0].absorption[c]);
        const double share = 1 / (kPi * radius2); // of the disc, by the slab of area one
        CHECK(traced.power.absorbed[c] / traced.power.emitted[c] ==
              Approx(share * absorbed).epsilon(0.02));
    }
}

TEST_CASE("trace photons: aimed paths bring the caustics that others bring, with more photons",
          "[photons]")
{
    ScenePointLight point;
    SceneSpotLight spot;
    SceneSunLight sun;
    point.position = spot.position = {0.1f, 0.35f, 0.2f};
    point.intensity = spot.intensity = sun.irradiance = {1, 2, 1};
    spot.direction = glm::normalize(glm::vec3(-0.3f, -0.6f, -0.2f));
    spot.cos_inner = 0.95f;
    spot.cos_outer = 0.8f;
    sun.direction = glm::normalize(glm::vec3(0.9f, -1, 0.1f));
    const int kind = GENERATE(0, 1, 2, 3, 4);
    Scene scene = open_room();
    if (kind != 3)
        scene.materials.back().emission = Rgb(0);
    scene.lights.clear();
    if (kind < 3)
        scene.lights = {std::vector<SceneLight>{point, spot, sun}[static_cast<std::size_t>(kind)]};
    if (kind == 4)
        scene.environment = {1, 0.5f, 2};
    const auto ready = tiny::ready(scene);

    RunningMean plain, aimed;
    std::size_t plain_photons = 0, aimed_photons = 0;
    const auto power_of = [](const TracedPhotons& traced) {
        double sum = 0;
        for (const Photon& photon : traced.caustic)
            sum += photon.power.y;
        return sum;
    };
    for (std::uint64_t pass = 0; pass < 24; ++pass) {
        const TracedPhotons without = trace_photons(*ready->render, {8000, 1, pass, false, 0});
        const TracedPhotons with = trace_photons(*ready->render, {1, 1, pass, false, 8000});
        plain.add(power_of(without));
        aimed.add(power_of(with));
        plain_photons += without.caustic.size();
        aimed_photons += with.caustic.size();
    }
    INFO("light " << kind << ": " << plain.mean() << " and " << aimed.mean());
    CHECK(std::abs(plain.mean() - aimed.mean()) <
          kMostZ * std::hypot(plain.standard_error(), aimed.standard_error()));
    CHECK(plain.standard_error() < 0.05 * plain.mean());
    CHECK(aimed_photons > plain_photons);
}

TEST_CASE("trace photons: lights in a glass ball make the same caustics by any paths", "[photons]")
{
    Scene scene = open_room();
    scene.materials.back().emission = Rgb(0);
    ScenePointLight outside;
    outside.position = {-0.45f, 0.45f, -0.45f};
    outside.intensity = Rgb(1);
    scene.lights.emplace_back(outside);
    TriangleMesh ball = tiny::uv_sphere(24, 12);
    tiny::scale(ball, 0.2f);
    tiny::move(ball, {0.1f, 0.1f, 0.2f}); // about the point light
    tiny::add(scene, ball, tiny::glass(1.5f));
    TriangleMesh face = tiny::floor_at(0.02f, 0.1f);
    tiny::move(face, {0.1f, 0.1f, 0.2f});
    tiny::add(scene, face, tiny::emissive({30, 20, 10}));
    const auto ready = tiny::ready(scene);
    REQUIRE(ready->render->enclosed_lights == std::vector<std::uint8_t>{1, 0, 1});

    PhotonGuides guides;
    for (auto [guide, lower] :
         {std::pair(&guides.without_aim, 0.8f), std::pair(&guides.aimed, 0.3f)}) {
        *guide = even_guide(ready->render->lights, Emitters::all_but_media);
        for (EmissionGuide::OfLight& light : guide->lights)
            light.density.nodes = {{1, 1, lower, 0.5f}, {}, {}};
    }
    PhotonOptions options{.paths = 8000, .seed = 1, .store_direct = true, .link_bounces = true};
    PhotonOptions with_aim = options, by_guides = options, alone = options;
    with_aim.caustic_paths = by_guides.caustic_paths = alone.caustic_paths = 4000;
    by_guides.guides = &guides;
    alone.store_direct = alone.light.indirect = false;
    const std::array all{options, with_aim, by_guides, alone};
    std::array<std::array<RunningMean, 2>, 4> power; // [options][caustic, bounced off it]
    for (std::uint64_t pass = 0; pass < 24; ++pass)
        for (std::size_t i = 0; i < all.size(); ++i) {
            PhotonOptions of_pass = all[i];
            of_pass.pass = pass;
            const TracedPhotons traced = trace_photons(*ready->render, of_pass);
            double caustic = 0, bounced = 0;
            for (const Photon& photon : traced.caustic)
                caustic += photon.power.y;
            for (const BouncedPhoton& photon : traced.bounces)
                bounced += photon.from_caustic ? photon.photon.power.y : 0;
            power[i][0].add(caustic);
            power[i][1].add(bounced);
        }
    for (std::size_t i = 1; i < all.size(); ++i)
        for (int kind = 0; kind < 2; ++kind) {
            const RunningMean &plain = power[0][kind], &other = power[i][kind];
            INFO("options " << i << ", kind " << kind << ": " << plain.mean() << " and "
                            << other.mean());
            CHECK(std::abs(plain.mean() - other.mean()) <
                  kMostZ * std::hypot(plain.standard_error(), other.standard_error()));
            CHECK(other.standard_error() < 0.03 * other.mean());
        }
}

TEST_CASE("bounced photons know the photon their light bounced from", "[photons]")
{
    const auto ready = tiny::ready(open_room());
    PhotonOptions options;
    options.paths = 3000;
    options.caustic_paths = 3000;
    options.store_direct = options.link_bounces = true;
    const TracedPhotons traced = trace_photons(*ready->render, options);
    std::size_t straight = 0, bent = 0, by_specular = 0, from_caustics = 0;
    for (const BouncedPhoton& bounced : traced.bounces) {
        const std::vector<Photon>& kept = bounced.from_caustic ? traced.caustic : traced.global;
        REQUIRE(bounced.from < kept.size());
        from_caustics += bounced.from_caustic;
        // Unless a ball was between, the light came from there.
        const glm::vec3 way = kept[bounced.from].position - bounced.photon.position;
        const bool is_straight = glm::dot(glm::normalize(way), bounced.photon.direction) > 0.9999f;
        straight += is_straight;
        CHECK((is_straight || bounced.by_specular));
        bent += !is_straight;
        by_specular += bounced.by_specular;
    }
    CHECK(bent > 20);
    CHECK(by_specular < 2 * bent); // few see the other side of a ball straight through its middle
    CHECK(from_caustics > 100);
    CHECK(traced.bounces.size() - from_caustics > 1000);
    CHECK(straight > traced.bounces.size() * 3 / 4);
    options.link_bounces = false;
    CHECK(trace_photons(*ready->render, options).bounces.empty());
}

TEST_CASE("trace photons: glass around a light absorbs from the light on", "[photons]")
{
    Material tinted = tiny::glass(1); // which neither refracts nor reflects
    tinted.absorption = {0.5f, 1.0f, 2.0f};
    Scene scene = tiny::make_scene(tiny::uv_sphere(96, 48)); // of radius 1
    scene.materials[0] = tinted;
    ScenePointLight light;
    light.intensity = Rgb(1);
    scene.lights.push_back(light);
    const auto ready = tiny::ready(std::move(scene));
    const TracedPhotons traced = trace_photons(*ready->render, {4096, 1, 0, true});
    for (int channel = 0; channel < 3; ++channel)
        CHECK(traced.power.escaped[channel] ==
              Approx(traced.power.emitted[channel] * std::exp(-tinted.absorption[channel]))
                  .epsilon(0.01));
}
