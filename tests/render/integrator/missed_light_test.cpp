#include "render/integrator/integrators.h"
#include "render/integrator/missed_light.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>
#include <tbb/global_control.h>

using namespace hipmap;

namespace {

constexpr float kHole = 0.04f; ///< side, of a wall of side 1

/// The wall between two rooms, at z = 0, with a square hole in its middle.
TriangleMesh wall_with_hole()
{
    const float low = -0.5f * kHole, far = 0.5f - 0.5f * kHole;
    TriangleMesh out = tiny::parallelogram({-0.5f, -0.5f, 0}, {1, 0, 0}, {0, far, 0});
    out = tiny::together(out, tiny::parallelogram({-0.5f, -low, 0}, {1, 0, 0}, {0, far, 0}));
    out = tiny::together(out, tiny::parallelogram({-0.5f, low, 0}, {far, 0, 0}, {0, kHole, 0}));
    return tiny::together(out, tiny::parallelogram({-low, low, 0}, {far, 0, 0}, {0, kHole, 0}));
}

/// A room with the camera and a closet with a light, between them a wall.  Floor and other walls
/// are those of both.
Scene room_and_closet(const TriangleMesh& wall)
{
    TriangleMesh mesh = tiny::cube();
    tiny::turn_inside_out(mesh);
    for (glm::vec3& position : mesh.positions)
        position.z *= 2;
    Scene scene = tiny::make_scene(mesh);
    scene.materials[0] = tiny::diffuse(Rgb(0.6f));
    tiny::add(scene, wall, tiny::diffuse(Rgb(0.6f)));
    TriangleMesh light = tiny::floor_at(0.45f, -0.3f);
    tiny::move(light, {0, 0, -0.5f});
    tiny::add(scene, light, tiny::emissive(Rgb(50)));
    scene.cameras[0].position = {0, 0, 0.96f};
    scene.cameras[0].tan_half_height = 0.8f;
    return scene;
}

Scene keyhole()
{
    return room_and_closet(wall_with_hole());
}

RenderOptions by_power_options(std::uint64_t photons)
{
    RenderOptions options;
    options.integrator = Integrator::progressive;
    options.width = options.height = 16;
    options.photons = photons;
    options.emission = Emission::by_power; // a guide would find the hole
    return options;
}

/// Passes of an image, and what they missed.
struct RenderedPasses {
    MissedLight missed;
    std::optional<ImageError> error;
    SeenClasses counts;
};

RenderedPasses render(const RenderScene& scene, const RenderOptions& options, std::uint64_t passes)
{
    RenderStatistics statistics;
    const PassSource source = make_pass_source(scene, options, statistics);
    Film film = make_film(source.width, source.height, source.pilot_mean, source.bias, false);
    for (std::uint64_t pass = 0; pass < passes; ++pass)
        add_pass(film, pass, source.render(pass, {}).images);
    return {find_missed_light(statistics, options.filter, film.pixel_count()), estimate_error(film),
            statistics.seen};
}

/// Light paths that leave a photon in the room.
int paths_into_room(const RenderScene& scene, const RenderOptions& options, std::uint64_t passes)
{
    int out = 0;
    for (std::uint64_t pass = 0; pass < passes; ++pass) {
        PhotonOptions photons;
        photons.paths = options.photons;
        photons.seed = options.seed;
        photons.pass = pass;
        photons.store_direct = photons.count_paths = true;
        const TracedPhotons traced = trace_photons(scene, photons);
        std::uint64_t begin = 0;
        for (const PhotonCounts& after : traced.after_path) {
            const auto first = traced.global.begin() + static_cast<std::ptrdiff_t>(begin);
            const auto end = traced.global.begin() + static_cast<std::ptrdiff_t>(after.global);
            out += std::any_of(first, end, [](const Photon& at) { return at.position.z > 0.01f; });
            begin = after.global;
        }
    }
    return out;
}

} // namespace

TEST_CASE("unseen light: a light behind a keyhole is warned of while it is unseen or seen once",
          "[integrator]")
{
    const auto ready = tiny::ready(keyhole());
    constexpr std::uint64_t kPasses = 4;
    int unseen = 0, warned = 0;
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        RenderOptions options = by_power_options(500);
        options.seed = seed;
        const RenderedPasses rendered = render(*ready->render, options, kPasses);
        if (paths_into_room(*ready->render, options, kPasses) > 1)
            continue;
        ++unseen;
        REQUIRE(rendered.missed.unseen);
        warned += is_much(*rendered.missed.unseen, rendered.error) ? 1 : 0;
    }
    REQUIRE(unseen >= 20);
    CHECK(warned >= 0.95 * unseen);
}

TEST_CASE("unseen light: a keyhole that many light paths found, and a room, are not warned of",
          "[integrator]")
{
    const auto check = [](const Scene& scene, RenderOptions options) {
        const auto ready = tiny::ready(scene);
        const RenderedPasses rendered = render(*ready->render, options, 4);
        REQUIRE(rendered.missed.unseen);
        CHECK(rendered.missed.unseen->most < 0.01);
        CHECK(!is_much(*rendered.missed.unseen, rendered.error));
    };
    RenderOptions guided = by_power_options(20000);
    guided.emission = Emission::guided;
    check(keyhole(), guided);
    check(tiny::room(), by_power_options(20000));
}

TEST_CASE("unseen light: without indirect light, a light that surfaces are lit by is not missed",
          "[integrator]")
{
    Scene scene = room_and_closet(tiny::parallelogram({-0.5f, -0.5f, 0}, {1, 0, 0}, {0, 1, 0}));
    ScenePointLight light;
    light.position = {0, 0.4f, 0.5f};
    light.intensity = Rgb(1);
    scene.lights.push_back(light);
    TriangleMesh ball = tiny::uv_sphere(16, 8);
    tiny::scale(ball, 0.15f);
    tiny::move(ball, {0, -0.3f, -0.5f});
    tiny::add(scene, ball, tiny::mirror(Rgb(0.9f)));
    const auto ready = tiny::ready(scene);
    RenderOptions options = by_power_options(2000);
    options.light.indirect = false;
    const RenderedPasses rendered = render(*ready->render, options, 1);
    CHECK(count_paths(rendered.counts) == 0); // all caustics are in the closet
    REQUIRE(rendered.missed.unseen);
    CHECK(rendered.missed.unseen->lights_never == 1); // of the closet
}

TEST_CASE("unseen light: the counts of an image do not depend on the number of threads",
          "[integrator]")
{
    const auto ready = tiny::ready(tiny::room());
    const auto rendered = [&](int threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                        static_cast<std::size_t>(threads));
        return render(*ready->render, by_power_options(5000), 2);
    };
    const RenderedPasses one = rendered(1), seven = rendered(7);
    CHECK(count_paths(one.counts) == count_paths(seven.counts));
    CHECK(one.counts.worth == seven.counts.worth);
    CHECK(one.missed.unseen->most == seven.missed.unseen->most);
    CHECK(one.missed.unseen->share == seven.missed.unseen->share);
}

TEST_CASE("lost light: widens the interval by its bound", "[integrator]")
{
    RenderStatistics statistics;
    CHECK(find_missed_light(statistics, PixelFilter::box, 100).lost.error2() == 0);
    statistics.emitted = 1000;
    statistics.dropped_photons = 20;
    statistics.dropped_samples = 1;
    const LostLight box = find_missed_light(statistics, PixelFilter::box, 10000).lost;
    CHECK(box.photons == Approx(0.02));
    CHECK(box.samples2 == Approx(1e-4));
    CHECK(find_missed_light(statistics, PixelFilter::b_spline, 10000).lost.samples2 ==
          Approx(9e-4));
    ImageError error;
    error.error = 0.03;
    error.high = 0.04;
    CHECK(with_lost_light(error, box).high == Approx(std::sqrt(0.0016 + 0.0004 + 0.0001)));
    CHECK(is_much(box, error));
    statistics.dropped_photons = 0;
    CHECK(!is_much(find_missed_light(statistics, PixelFilter::box, 1000000).lost, error));
    statistics.cut_paths = 1;
    CHECK(find_missed_light(statistics, PixelFilter::box, 1000000).lost.photons ==
          Approx(1.0).epsilon(0.001));
}
