#include "render/integrator/integrators.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>

#include <array>

using namespace hipmap;

namespace {

Material flint(float roughness)
{
    Material material = tiny::glass(1.6f);
    material.dispersion = 2;
    material.roughness = roughness;
    return material;
}

using Channels = std::array<RunningMean, 3>;

/// ColourMeans of the channels over the image, and the same by narrower radii.
struct ColourMeans {
    Channels radiance, narrower;
};

void add(const Image& image, Channels& to)
{
    for (int c = 0; c < 3; ++c) {
        double sum = 0;
        for (const Rgb& pixel : image.pixels)
            sum += pixel[c];
        to[c].add(sum / static_cast<double>(image.pixels.size()));
    }
}

ColourMeans render(const Scene& scene, Integrator integrator, std::size_t samples,
                   std::uint64_t passes)
{
    const auto ready = tiny::ready(scene);
    RenderOptions options;
    options.integrator = integrator;
    options.width = options.height = 16;
    options.photons = 20000;
    options.samples = samples;
    options.dissertation.mode = MapMode::shared;
    RenderStatistics ignored;
    const PassSource source = make_pass_source(*ready->render, options, ignored);
    ColourMeans out;
    for (std::uint64_t pass = 0; pass < passes; ++pass) {
        const RenderedPass rendered = source.render(pass, {});
        add(rendered.images.radiance, out.radiance);
        if (source.bias == BiasKnowledge::from_radii)
            add(rendered.images.narrower, out.narrower);
    }
    return out;
}

TriangleMesh ball()
{
    TriangleMesh mesh = tiny::uv_sphere(16, 8);
    tiny::scale(mesh, 0.2f);
    return mesh;
}

} // namespace

TEST_CASE("dispersion: in even light glass of any colour is not seen", "[integrator]")
{
    Scene scene = tiny::emissive_box(Rgb(0.5f));
    tiny::add(scene, ball(), flint(0));
    const ColourMeans paths = render(scene, Integrator::path, 16, 8);
    for (const RunningMean& channel : paths.radiance)
        CHECK(std::abs(channel.z_score(1)) < kMostZ);
}

TEST_CASE("dispersion: rough glass loses no more in any colour than without", "[integrator]")
{
    Scene scene = tiny::emissive_box(Rgb(0.5f));
    tiny::add(scene, ball(), flint(0.3f));
    const ColourMeans paths = render(scene, Integrator::path, 16, 12);
    scene.materials.back().dispersion = 0;
    const ColourMeans plain = render(scene, Integrator::path, 16, 12);
    for (int c = 0; c < 3; ++c) {
        const double noise =
            std::hypot(paths.radiance[c].standard_error(), plain.radiance[c].standard_error());
        CHECK(std::abs(paths.radiance[c].mean() - plain.radiance[c].mean()) < kMostZ * noise);
        CHECK(noise < 0.006);
    }
}

TEST_CASE("dispersion: maps find the colours that paths find", "[integrator]")
{
    Scene scene = tiny::box(tiny::diffuse({0.7f, 0.6f, 0.5f}));
    tiny::add(scene, ball(), flint(0));
    tiny::add(scene, tiny::floor_at(0.45f, -0.3f), tiny::emissive(Rgb(5)));
    const ColourMeans gathered = render(scene, Integrator::progressive, 16, 12);
    const ColourMeans paths = render(scene, Integrator::path, 100, 12);
    for (int c = 0; c < 3; ++c) {
        INFO("channel " << c);
        const RunningMean& ours = gathered.radiance[c];
        const RunningMean& referee = paths.radiance[c];
        const double bias = 2 * std::abs(ours.mean() - gathered.narrower[c].mean());
        const double noise = std::hypot(ours.standard_error(), referee.standard_error());
        CHECK(std::abs(ours.mean() - referee.mean()) < bias + kMostZ * noise);
        CHECK(bias + kMostZ * noise < 0.05 * referee.mean());
    }
}
