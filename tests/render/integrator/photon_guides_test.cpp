#include "render/integrator/emission_seeds.h"
#include "render/integrator/importons.h"
#include "render/integrator/integrators.h"
#include "render/integrator/photon_cache.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>
#include <tbb/global_control.h>

#include <algorithm>

using namespace hipmap;

namespace {

/// A box without a top on a plain forty times as wide, below a sun; the camera is in the box.
Scene box_on_a_plain()
{
    TriangleMesh mesh = tiny::open_box();
    tiny::turn_inside_out(mesh);
    Scene scene = tiny::make_scene(mesh);
    scene.materials[0] = tiny::diffuse(Rgb(0.7f));
    scene.cameras[0].position = {0, 0, 0.48f};
    scene.cameras[0].tan_half_height = 0.8f;
    TriangleMesh plain = tiny::floor_at(-0.6f, 40);
    tiny::add(scene, plain, tiny::diffuse(Rgb(0.3f)));
    SceneSunLight sun;
    sun.irradiance = glm::dvec3(5);
    sun.direction = glm::normalize(glm::dvec3(0.5, -1, -0.3));
    scene.lights.push_back(sun);
    return scene;
}

/// A box without the side that looks to a low sun, on a plain: the sun lights its floor, and the
/// plain its ceiling.
Scene box_open_to_the_sun()
{
    TriangleMesh box = tiny::open_box();
    for (glm::vec3& position : box.positions)
        std::swap(position.x, position.y); // which turns it inside out
    Scene scene = tiny::make_scene(box);
    scene.materials[0] = tiny::diffuse(Rgb(0.3f));
    tiny::add(scene, tiny::floor_at(-0.6f, 20), tiny::diffuse(Rgb(0.5f)));
    SceneSunLight sun;
    sun.irradiance = glm::dvec3(5);
    sun.direction = glm::normalize(glm::dvec3(-1, -0.5, 0.1));
    scene.lights.push_back(sun);
    return scene;
}

/// Two closed rooms, each with a lamp; the camera is in the first.
Scene two_rooms()
{
    Scene scene = tiny::room();
    TriangleMesh other = tiny::cube();
    tiny::turn_inside_out(other);
    tiny::move(other, {5, 0, 0});
    tiny::add(scene, other, tiny::diffuse(Rgb(0.7f)));
    TriangleMesh lamp = tiny::floor_at(0.45f, -0.3f);
    tiny::move(lamp, {5, 0, 0});
    tiny::add(scene, lamp, tiny::emissive(Rgb(50)));
    return scene;
}

RenderOptions small_options(Emission emission, Integrator integrator = Integrator::progressive)
{
    RenderOptions options;
    options.integrator = integrator;
    options.width = options.height = 16;
    options.photons = 20000;
    options.samples = 4;
    options.emission = emission;
    return options;
}

/// What photons are worth where importons lie evenly on the ceiling of a box.
PhotonWorth worth_on_ceiling(const RenderScene& scene, const MapSurfaces& surfaces, int count)
{
    Importons importons;
    RandomSequence random(1, RandomStream::pictures, 0, 0);
    const FaceId ceiling = scene.rays.nearest({.direction = {0, 1, 0}})->face;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 place{random.next() - 0.5f, 0.5f, random.next() - 0.5f};
        importons.global.push_back({place, Rgb(1), {0, -1, 0}, ceiling, 0});
    }
    return make_worth(importons, surfaces,
                      [](const TracedPhotons&) { return std::vector<Photon>(); });
}

struct EmittedMeans {
    RunningMean radiance, narrower;
    RunningMean noise; ///< mean square of the difference of a pixel between two passes

    /// Bias that goes with the radius itself is halved in the narrowest; else it is less.
    double bias() const { return 2 * std::abs(radiance.mean() - narrower.mean()); }
};

EmittedMeans mean_of_passes(const tiny::ReadyScene& ready, Emission emission,
                            std::uint64_t seed = 0)
{
    RenderStatistics ignored;
    RenderOptions options = small_options(emission);
    options.seed = seed;
    const PassSource source = make_pass_source(*ready.render, options, ignored);
    EmittedMeans out;
    Image last;
    for (std::uint64_t pass = 0; pass < 10; ++pass) {
        const RenderedPass rendered = source.render(pass, {});
        const Image& now = rendered.images.radiance;
        for (std::size_t i = 0; i < last.pixels.size(); ++i) {
            const Rgb off = now.pixels[i] - last.pixels[i];
            out.noise.add(glm::dot(off, off));
        }
        last = now;
        out.radiance.add(mean_of(rendered.images.radiance));
        out.narrower.add(mean_of(rendered.images.narrower));
    }
    return out;
}

} // namespace

TEST_CASE("photon guides: the image is that of emission by power", "[integrator]")
{
    const auto same = [](const EmittedMeans& a, const EmittedMeans& b) {
        const double noise = std::hypot(a.radiance.standard_error(), b.radiance.standard_error());
        const double most = a.bias() + b.bias() + kMostZ * noise;
        CHECK(std::abs(a.radiance.mean() - b.radiance.mean()) < most);
        CHECK(most < 0.1 * b.radiance.mean());
    };
    const auto plain = tiny::ready(box_on_a_plain());
    const EmittedMeans guided = mean_of_passes(*plain, Emission::guided);
    const EmittedMeans by_power = mean_of_passes(*plain, Emission::by_power);
    same(guided, by_power);
    // By one seed it is 0.5 to 0.76.
    double noise = guided.noise.mean(), noise_by_power = by_power.noise.mean();
    for (const std::uint64_t seed : {1, 2, 3, 4, 5}) {
        noise += mean_of_passes(*plain, Emission::guided, seed).noise.mean();
        noise_by_power += mean_of_passes(*plain, Emission::by_power, seed).noise.mean();
    }
    CHECK(noise < 0.7 * noise_by_power);
    const auto rooms = tiny::ready(two_rooms());
    same(mean_of_passes(*rooms, Emission::guided), mean_of_passes(*rooms, Emission::by_power));
}

TEST_CASE("photon guides: paths are aimed as far as caustics are seen", "[integrator]")
{
    const auto aimed_for_each = [](const glm::vec3& ball_at) {
        Scene scene = box_on_a_plain();
        scene.materials[0] = tiny::diffuse(Rgb(0.05f)); // little indirect light
        TriangleMesh ball = tiny::uv_sphere(16, 8);
        tiny::scale(ball, 0.15f);
        tiny::move(ball, ball_at);
        tiny::add(scene, ball, tiny::glass(1.5f));
        const auto ready = tiny::ready(std::move(scene));
        RenderStatistics statistics;
        const RenderOptions options = small_options(Emission::guided);
        make_pass_source(*ready->render, options, statistics).render(0, {});
        return static_cast<double>(statistics.aimed) / static_cast<double>(statistics.emitted);
    };
    const double seen = aimed_for_each({0, -0.2f, 0}), unseen = aimed_for_each({15, -0.4f, 0});
    CHECK(unseen == Approx(1.0 / 32).epsilon(0.01)); // the fewest
    CHECK(seen > 8 * unseen);
    CHECK(seen <= 0.5);
}

TEST_CASE("photon guides: seeds are starts of paths that reach the importons", "[integrator]")
{
    Importons importons;
    for (const float x : {-0.3f, 0.1f, 0.4f})
        importons.global.push_back({{x, -0.5f, 0.2f}, Rgb(1), {0, 1, 0}, 0, 0});
    importons.indirect = importons.global; // otherwise there are seeds by a bounce
    const auto check_seeds = [&](const Scene& scene) {
        const auto ready = tiny::ready(scene);
        const LightSet& lights = ready->render->lights;
        const std::vector<EmissionSeed> seeds = emission_seeds(*ready->render, importons, 0);
        REQUIRE(!seeds.empty());
        for (const EmissionSeed& seed : seeds) {
            RandomSequence random(0, RandomStream::photons, 0, 0);
            random.give(seed.at);
            const Ray ray = sample_emission(lights.lights[seed.light], {}, random).ray;
            const auto misses = [&](const Photon& importon) {
                const glm::vec3 way = importon.position - ray.origin;
                return glm::length(way - glm::dot(way, ray.direction) * ray.direction) > 0.01f;
            };
            CHECK_FALSE(std::ranges::all_of(importons.global, misses));
            CHECK(seed.weight > 0);
        }
    };
    Scene scene = box_on_a_plain();
    scene.lights.clear();
    scene.environment = Rgb(2);
    check_seeds(scene);
    scene.environment = Rgb(0);
    for (const double half_angle : {0.0, 0.05}) {
        SceneSunLight sun;
        sun.irradiance = glm::dvec3(5);
        sun.direction = glm::normalize(glm::dvec3(0.1, -1, -0.1));
        sun.half_angle = half_angle;
        scene.lights = {sun};
        check_seeds(scene);
    }
}

TEST_CASE("photon guides: seeds lead to what is seen from the importons, if none lies there",
          "[integrator]")
{
    const auto ready = tiny::ready(box_on_a_plain());
    Importons importons;
    for (int i = 0; i < 50; ++i) // in the shadow of a wall
        importons.global.push_back(
            {{-0.4f, -0.5f, 0.004f * static_cast<float>(i)}, Rgb(1), {0, 1, 0}, 0, 0});
    const RenderScene& scene = *ready->render;
    const std::vector<EmissionSeed> seeds = emission_seeds(scene, importons, 0);
    CHECK(seeds.size() > 20);
    for (const EmissionSeed& seed : seeds) {
        RandomSequence random(0, RandomStream::photons, 0, 0);
        random.give(seed.at);
        const Ray ray = sample_emission(scene.lights.lights[seed.light], {}, random).ray;
        const auto hit = scene.rays.nearest(ray);
        REQUIRE(hit);
        const float height = interact(scene, ray, *hit).point.position.y;
        CHECK(std::abs(height) < 0.499f); // of a wall, not of the floor
        CHECK(seed.weight > 0);
    }
    importons.indirect = importons.global;
    CHECK(emission_seeds(scene, importons, 0).empty());
}

TEST_CASE(
    "photon guides: a pass has the same bits by any number of threads, with a cache or without",
    "[integrator]")
{
    const auto ready = tiny::ready(box_on_a_plain());
    const RenderOptions options = small_options(Emission::guided);
    const auto third_pass = [&](std::size_t threads, PhotonCache* cache = nullptr) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        RenderStatistics ignored;
        return make_pass_source(*ready->render, options, ignored, cache).render(3, {}).images;
    };
    const PassImages one = third_pass(1);
    CHECK(mean_of(one.radiance) > 0.1);
    for (const std::size_t threads : {2, 7})
        CHECK(one.radiance.pixels == third_pass(threads).radiance.pixels);
    // Guides are of one camera: photons that they aim are not kept for another one.
    PhotonCache cache;
    cache.most = std::size_t{1} << 30;
    for (int frame = 0; frame < 2; ++frame)
        CHECK(one.radiance.pixels == third_pass(2, &cache).radiance.pixels);
    CHECK(cache.passes.empty());
}

TEST_CASE("photon guides: where all photons matter alike there is none", "[integrator]")
{
    const auto ready = tiny::ready(tiny::emissive_box(Rgb(0.5f)));
    const auto pass = [&](Emission emission) {
        RenderStatistics ignored;
        const RenderOptions options = small_options(emission);
        return make_pass_source(*ready->render, options, ignored).render(0, {}).images;
    };
    CHECK(pass(Emission::guided).radiance.pixels == pass(Emission::by_power).radiance.pixels);
}

TEST_CASE("photon guides: direct estimates have less noise and less bias by them", "[integrator]")
{
    const auto plain = tiny::ready(box_on_a_plain());
    constexpr int kPasses = 10;
    const auto images = [&](const RenderOptions& options) {
        RenderStatistics ignored;
        const PassSource source = make_pass_source(*plain->render, options, ignored);
        std::vector<Image> out;
        for (std::uint64_t pass = 0; pass < kPasses; ++pass)
            out.push_back(source.render(pass, {}).images.radiance);
        return out;
    };
    const auto mean_of_images = [](const std::vector<Image>& of) {
        Image sum(of[0].width, of[0].height);
        for (const Image& image : of)
            for (std::size_t i = 0; i < sum.pixels.size(); ++i)
                sum.pixels[i] += image.pixels[i] / static_cast<float>(of.size());
        return sum;
    };
    const auto distance = [](const Image& a, const Image& b) {
        double sum = 0;
        for (std::size_t i = 0; i < a.pixels.size(); ++i)
            sum += double{glm::dot(a.pixels[i] - b.pixels[i], a.pixels[i] - b.pixels[i])};
        return sum;
    };
    RenderOptions long_path = small_options(Emission::by_power, Integrator::path);
    long_path.samples = 1024;
    const Image truth = mean_of_images(images(long_path));
    const auto guided = images(small_options(Emission::guided, Integrator::direct));
    const auto by_power = images(small_options(Emission::by_power, Integrator::direct));
    const double error = distance(mean_of_images(guided), truth);
    const double error_by_power = distance(mean_of_images(by_power), truth);
    const double noise = distance(guided[0], guided[1]);
    const double noise_by_power = distance(by_power[0], by_power[1]);
    INFO(error << " " << error_by_power << "; " << noise << " " << noise_by_power);
    CHECK(error < 0.7 * error_by_power);
    CHECK(noise < 0.2 * noise_by_power);
}

TEST_CASE("photon guides: direct estimates have the same bits by any number of threads, and by "
          "power where photons matter alike or the dissertation's methods are compared",
          "[integrator]")
{
    const auto plain = tiny::ready(box_on_a_plain()),
               box = tiny::ready(tiny::emissive_box(Rgb(0.5f)));
    const auto pass = [](const tiny::ReadyScene& ready, const RenderOptions& options,
                         std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        RenderStatistics ignored;
        return make_pass_source(*ready.render, options, ignored)
            .render(3, {})
            .images.radiance.pixels;
    };
    RenderOptions guided = small_options(Emission::guided, Integrator::direct);
    RenderOptions by_power = small_options(Emission::by_power, Integrator::direct);
    const std::vector<Rgb> one = pass(*plain, guided, 1);
    CHECK(one == pass(*plain, guided, 2));
    CHECK(one == pass(*plain, guided, 7));
    CHECK(one != pass(*plain, by_power, 2));
    CHECK(pass(*box, guided, 2) == pass(*box, by_power, 2));
    guided.dissertation.estimate = by_power.dissertation.estimate = EstimateForm::thesis;
    CHECK(pass(*plain, guided, 2) == pass(*plain, by_power, 2));
}

TEST_CASE("photon guides: paths split where they find what is seen", "[integrator]")
{
    const auto ready = tiny::ready(box_open_to_the_sun());
    const RenderScene& scene = *ready->render;
    const MapSurfaces surfaces(scene.mesh(), ready->partition);
    const PhotonWorth worth = worth_on_ceiling(scene, surfaces, 2000);
    const EmissionGuide by_power = even_guide(scene.lights, Emitters::all);
    PhotonGuides guides{by_power, by_power};
    PhotonOptions photons{.paths = 400000, .seed = 1, .pass = 1000};
    photons.count_paths = photons.keep_arrivals = true;
    WorthOfPaths found = worth_of_paths({scene, surfaces}, worth, trace_photons(scene, photons));
    double squares = 0;
    for (const double path : found.paths)
        squares += path * path;
    const double usual = std::sqrt(squares * static_cast<double>(photons.paths));
    photons.paths = 10000;
    const auto power_on_ceiling = [&](const PathSplitting& splitting) {
        RunningMean out;
        guides.splitting = splitting;
        photons.guides = &guides;
        for (photons.pass = 0; photons.pass < 300; ++photons.pass) {
            double power = 0;
            for (const Photon& photon : trace_photons(scene, photons).global)
                power += photon.position.y > 0.49f ? double{photon.power.x} : 0;
            out.add(power);
        }
        return out;
    };
    const RunningMean whole = power_on_ceiling({});
    const RunningMean split =
        power_on_ceiling(learn_splitting(ready->partition, found.arrivals, usual));
    INFO(split.standard_error() << " of " << split.mean() << ", without splitting "
                                << whole.standard_error() << " of " << whole.mean());
    const double noise = std::hypot(split.standard_error(), whole.standard_error());
    CHECK(std::abs(split.mean() - whole.mean()) < kMostZ * noise);
    CHECK(kMostZ * noise < 0.25 * whole.mean());
    CHECK(split.standard_error() < 0.75 * whole.standard_error());
}

TEST_CASE("photon guides: photons bring less noise the more of the image reads each",
          "[integrator]")
{
    const auto ready = tiny::ready(box_open_to_the_sun());
    const RenderScene& scene = *ready->render;
    const MapSurfaces surfaces(scene.mesh(), ready->partition);
    PhotonWorth worth = worth_on_ceiling(scene, surfaces, 4000);
    const TracedPhotons traced =
        trace_photons(scene, {.paths = 400000, .seed = 1, .count_paths = true});
    const auto noise_over_squares = [&] {
        const WorthOfPaths found = worth_of_paths({scene, surfaces}, worth, traced);
        double noise = 0, squares = 0;
        for (std::size_t path = 0; path < found.paths.size(); ++path) {
            noise += found.noise[path];
            squares += found.paths[path] * found.paths[path];
        }
        REQUIRE(squares > 0);
        return noise / squares;
    };
    CHECK(noise_over_squares() == 1);
    const auto even = [&](std::uint32_t neighbours) {
        FirstRadii radii;
        radii.global = build_radius_field(
            build_chosen_maps(traced.global, surfaces, {.neighbours = neighbours}, {}), surfaces,
            {});
        worth.radii = &radii;
        return noise_over_squares();
    };
    const double narrow = even(4), wide = even(16);
    INFO(narrow << " and " << wide);
    CHECK(wide < 0.5 * narrow);
    CHECK(narrow < 0.05);
    worth.rays = 4;
    CHECK(even(16) == Approx(wide / 4));
}
