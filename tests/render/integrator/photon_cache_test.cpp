#include "render/integrator/integrators.h"
#include "render/integrator/photon_cache.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>

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

TwoPasses render(const Scene& scene, PhotonCache* cache,
                 GatheredIrradiance irradiance = GatheredIrradiance::estimated)
{
    const auto ready = tiny::ready(scene);
    RenderOptions options;
    options.width = options.height = 12;
    options.photons = 3000;
    options.dissertation.irradiance = irradiance;
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
