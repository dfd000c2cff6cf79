#include "render/integrator/integrators.h"
#include "render/integrator/photon_cache.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>
#include <tbb/global_control.h>

using namespace hipmap;

namespace {

/// A room with glass, mirror and fog, from a camera at such a place.
Scene room_from(float x)
{
    Scene scene = tiny::room();
    scene.around.scattering = Rgb(0.3f);
    scene.cameras[0].position.x = x;
    return scene;
}

struct TwoPasses {
    std::vector<Rgb> pixels;
    RenderStatistics statistics;

    bool operator==(const TwoPasses& other) const
    {
        return pixels == other.pixels && statistics.emitted == other.statistics.emitted &&
               statistics.volume_photons == other.statistics.volume_photons &&
               statistics.indirect.stored == other.statistics.indirect.stored &&
               statistics.caustic.shared_maps == other.statistics.caustic.shared_maps &&
               statistics.power.absorbed == other.statistics.power.absorbed;
    }
};

/// Two closed boxes, each with a light; a ball at such a place in the first.
Scene boxes_with_ball(float x)
{
    Scene scene = tiny::box(tiny::diffuse(Rgb(0.6f)));
    tiny::add(scene, tiny::floor_at(0.45f, -0.3f), tiny::emissive(Rgb(5)));
    TriangleMesh walls = tiny::cube(), light = tiny::floor_at(0.45f, -0.3f);
    tiny::turn_inside_out(walls);
    tiny::move(walls, {3, 0, 0});
    tiny::move(light, {3, 0, 0});
    tiny::add(scene, walls, tiny::diffuse(Rgb(0.6f)));
    tiny::add(scene, light, tiny::emissive(Rgb(5)));
    TriangleMesh ball = tiny::uv_sphere(16, 8);
    tiny::scale(ball, 0.15f);
    tiny::move(ball, {x, -0.3f, 0});
    tiny::add(scene, ball, tiny::diffuse(Rgb(0.5f)));
    return scene;
}

TwoPasses render(const Scene& scene, PhotonCache* cache,
                 GatheredIrradiance irradiance = GatheredIrradiance::estimated,
                 Emission emission = Emission::guided)
{
    const auto ready = tiny::ready(scene);
    RenderOptions options;
    options.width = options.height = 12;
    options.photons = 3000;
    options.dissertation.irradiance = irradiance;
    options.emission = emission;
    TwoPasses out;
    const PassSource source = make_pass_source(*ready->render, options, out.statistics, cache);
    for (std::uint64_t pass = 0; pass < 2; ++pass)
        for (const Rgb& pixel : source.render(pass, {}).images.radiance.pixels)
            out.pixels.push_back(pixel);
    return out;
}

} // namespace

TEST_CASE("photon cache: a second camera sees the same with photons of the first and its own",
          "[motion]")
{
    for (const GatheredIrradiance irradiance :
         {GatheredIrradiance::estimated, GatheredIrradiance::precomputed}) {
        PhotonCache cache;
        cache.most = std::size_t{1} << 30;
        CHECK(render(room_from(0), &cache, irradiance) ==
              render(room_from(0), nullptr, irradiance));
        CHECK(cache.served == 0);
        CHECK(cache.passes.size() == 3); // and the pilot's
        CHECK(cache.bytes > 0);
        const TwoPasses with = render(room_from(0.1f), &cache, irradiance);
        CHECK(with == render(room_from(0.1f), nullptr, irradiance));
        CHECK(with.statistics.seconds_photons == 0);
        CHECK(cache.served == 2);
    }
}

TEST_CASE("photon cache: what does not fit is made anew", "[motion]")
{
    PhotonCache cache;
    cache.most = 1;
    render(room_from(0), &cache);
    CHECK(cache.passes.empty());
    CHECK(cache.bytes == 0);
    CHECK(render(room_from(0.1f), &cache) == render(room_from(0.1f), nullptr));
    CHECK(cache.served == 0);
}

TEST_CASE("photon cache: a scene in which a ball has moved takes over the maps of the other box, "
          "with the same image",
          "[motion]")
{
    const auto render_by_power = [](const Scene& scene, PhotonCache* cache) {
        return render(scene, cache, GatheredIrradiance::estimated, Emission::by_power);
    };
    for (const std::size_t threads : {1, 3}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        PhotonCache cache;
        cache.most = std::size_t{1} << 30;
        render_by_power(boxes_with_ball(0), &cache);
        CHECK(cache.taken_over == 0);
        change_scene(cache);
        CHECK(cache.passes.empty());
        CHECK(cache.previous.size() == 3); // with the pilot's
        cache.taken_over = cache.built = 0;
        const TwoPasses with = render_by_power(boxes_with_ball(0.1f), &cache);
        CHECK(with == render_by_power(boxes_with_ball(0.1f), nullptr));
        CHECK(cache.taken_over >= 3 * 6); // six walls of the still box in three passes
        CHECK(cache.built > 0);
        CHECK(cache.previous.empty());
        std::size_t bytes = 0;
        for (const auto& [number, pass] : cache.passes)
            bytes += pass.maps->bytes();
        CHECK(cache.bytes == bytes);
    }
}
