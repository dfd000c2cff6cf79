#include "tests/support/means_of_images.h"
#include "tests/support/render_image.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>

using namespace hipmap;

TEST_CASE("path tracer and photon maps agree on a room with glass and mirror", "[integrator]")
{
    const auto ready = tiny::ready(tiny::room());
    ImageOptions options;
    options.width = 24;
    options.height = 16;
    options.photons = 20000;
    check_agreement(*ready, options, 8, 25, {.with_maps = Integrator::direct});
}
