#include "render/photons/trace_photons.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>
#include <tbb/global_control.h>

using namespace hipmap;

namespace {

/// A room with a light, glass and mirror, a cube of fog, and thin haze everywhere.
Scene misty_room()
{
    Scene scene = tiny::with_glass_and_mirror(tiny::box(tiny::diffuse(Rgb(0.6f))), Rgb(0.9f));
    TriangleMesh cube = tiny::cube();
    tiny::scale(cube, 0.2f);
    tiny::move(cube, {0, 0.2f, 0.1f});
    Material fog;
    fog.boundary = false;
    fog.scattering = {5, 10, 20};
    fog.absorption = {1, 0, 2};
    tiny::add(scene, cube, fog);
    scene.around.scattering = {0.5f, 1, 0.25f};
    ScenePointLight light;
    light.position = {0.1f, 0.42f, 0.02f};
    light.intensity = {1, 2, 3};
    scene.lights = {light};
    return scene;
}

PhotonOptions options_of(std::uint64_t paths, std::uint64_t pass)
{
    PhotonOptions options;
    options.paths = paths;
    options.caustic_paths = paths / 4;
    options.pass = pass;
    options.link_bounces = options.store_direct = options.media = true;
    return options;
}

} // namespace

TEST_CASE("photons in media: what is sent out is absorbed or leaves", "[photons][media]")
{
    Scene scene = misty_room();
    std::swap(scene.mesh.corners[0], scene.mesh.corners[1]);
    scene.mesh.corners[0].y = scene.mesh.corners[0].x; // a face without area: half a wall is open
    const auto ready = tiny::ready(scene);
    std::array<RunningMean, 3> lost;
    for (std::uint64_t pass = 0; pass < 24; ++pass) {
        const TracedPhotons traced = trace_photons(*ready->render, options_of(500, pass));
        CHECK(traced.dropped == 0);
        CHECK(traced.cut == 0);
        for (int c = 0; c < 3; ++c)
            lost[c].add((traced.power.absorbed[c] + traced.power.escaped[c]) /
                        traced.power.emitted[c]);
    }
    for (const RunningMean& channel : lost)
        CHECK(std::abs(channel.z_score(1)) < kMostZ);
}

TEST_CASE("photons in media: each lies in the medium it names, and links are of this pass",
          "[photons][media]")
{
    const auto ready = tiny::ready(misty_room());
    const MediaSet& media = ready->render->media.value();
    const TracedPhotons traced = trace_photons(*ready->render, options_of(2000, 0));
    REQUIRE(traced.volume.size() > 500);
    for (const VolumePhoton& photon : traced.volume)
        CHECK(medium_stack_at(media, photon.position).current() == photon.inside);
    std::size_t by_media = 0;
    for (const BouncedPhoton& bounced : traced.bounces) {
        by_media += bounced.from == kNoPhoton ? 1 : 0;
        if (bounced.from != kNoPhoton)
            CHECK(bounced.from < (bounced.from_caustic ? traced.caustic : traced.global).size());
    }
    CHECK(by_media > 0);
    CHECK(by_media < traced.bounces.size());
}

TEST_CASE("photons in media: the same at any number of threads", "[photons][media]")
{
    const auto ready = tiny::ready(misty_room());
    const auto trace = [&] { return trace_photons(*ready->render, options_of(10000, 1)); };
    const TracedPhotons many = trace();
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const TracedPhotons alone = trace();
    CHECK(std::equal(many.volume.begin(), many.volume.end(), alone.volume.begin(),
                     alone.volume.end(), [](const VolumePhoton& a, const VolumePhoton& b) {
                         return a.position == b.position && a.power == b.power &&
                                a.travel == b.travel && a.inside == b.inside;
                     }));
}

TEST_CASE("emissive media: light paths carry 4 pi e times their volume", "[photons][media]")
{
    Scene scene = tiny::box(tiny::diffuse(Rgb(0.5f)));
    TriangleMesh cube = tiny::cube();
    tiny::scale(cube, 0.3f);
    Material emitted;
    emitted.boundary = false;
    emitted.medium_emission = {1, 2, 3};
    tiny::add(scene, cube, emitted);
    tiny::scale(cube, 0.5f); // darker, and inside the other
    emitted.medium_emission = {0.5f, 0, 0};
    tiny::add(scene, cube, emitted);
    const auto ready = tiny::ready(scene);
    const double outer = std::pow(0.3, 3), inner = std::pow(0.15, 3);
    std::array<RunningMean, 3> power;
    for (std::uint64_t i = 0; i < 8000; ++i) {
        RandomSequence random(7, RandomStream::photons, 0, i);
        const MediaEmission path = sample_media_emission(*ready->render->media, random);
        for (int c = 0; c < 3; ++c)
            power[c].add(path.power[c]);
        if (!is_black(path.power))
            CHECK(medium_stack_at(*ready->render->media, path.ray.origin).count > 0);
    }
    for (int c = 0; c < 3; ++c)
        CHECK(std::abs(power[c].z_score(
                  4 * M_PI * ((c + 1) * (outer - inner) + (c == 0 ? 0.5 * inner : 0)))) < kMostZ);
}
