#include "render/integrator/integrators.h"
#include "tests/support/means_of_images.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>
#include <tbb/global_control.h>

using namespace hipmap;

namespace {

RenderOptions small_options(GatherSharing sharing)
{
    RenderOptions options;
    options.integrator = Integrator::progressive;
    options.width = 37;
    options.height = 21;
    options.photons = 20000;
    options.samples = 4;
    options.sharing = sharing;
    return options;
}

/// Mean square of the relative difference of a pixel between two passes.
double noise_of(const RenderScene& scene, GatherSharing sharing)
{
    RenderStatistics ignored;
    const RenderOptions options = small_options(sharing);
    const PassSource source = make_pass_source(scene, options, ignored);
    RunningMean out;
    Image last;
    for (std::uint64_t pass = 0; pass < 6; ++pass) {
        const Image now = source.render(pass, {}).images.radiance;
        for (std::size_t i = 0; i < last.pixels.size(); ++i) {
            const Rgb off = now.pixels[i] - last.pixels[i], sum = now.pixels[i] + last.pixels[i];
            out.add(glm::dot(off, off) / (1e-3 + glm::dot(sum, sum)));
        }
        last = now;
    }
    return out.mean();
}

PassImages third_pass(const RenderScene& scene, const PixelRect& crop, std::size_t threads)
{
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    RenderOptions options = small_options(GatherSharing::neighbours);
    options.crop = crop;
    RenderStatistics ignored;
    return make_pass_source(scene, options, ignored).render(3, {}).images;
}

Scene room_of(const Material& walls)
{
    Scene scene = tiny::with_glass_and_mirror(tiny::box(walls), Rgb(0.9f));
    tiny::add(scene, tiny::floor_at(0.45f, -0.3f), tiny::emissive(Rgb(5)));
    return scene;
}

/// Returns a rough diffuse material; its radiance depends a little on the direction.
Material plaster()
{
    Material out = tiny::diffuse({0.7f, 0.6f, 0.5f});
    out.diffuse_model = DiffuseModel::oren_nayar;
    out.roughness = 1;
    return out;
}

/// Returns a diffuse material under a glossy layer, which reflects most light at grazing angles.
Material plastic()
{
    Material out = tiny::diffuse({0.7f, 0.6f, 0.5f});
    out.specular = 1;
    out.roughness = 0.2f;
    return out;
}

/// Returns a diffuse material under a smooth clear coat.
Material lacquer()
{
    Material out = tiny::diffuse({0.7f, 0.6f, 0.5f});
    out.clearcoat = 1;
    out.clearcoat_roughness = 0;
    return out;
}

} // namespace

TEST_CASE("shared gathers: with those of neighbours the image is that of paths", "[integrator]")
{
    ImageOptions options;
    static_cast<RenderOptions&>(options) = small_options(GatherSharing::neighbours);
    options.width = options.height = 16;
    check_agreement(*tiny::ready(tiny::room()), options, 8, 30);
    for (const Material& walls : {plaster(), plastic(), lacquer()})
        check_agreement(*tiny::ready(room_of(walls)), options, 8, 30);
}

TEST_CASE("shared gathers: lessen the noise of diffuse walls", "[integrator]")
{
    Scene scene = tiny::box(tiny::diffuse(Rgb(0.7f)));
    ScenePointLight light; // no noise of its own
    light.position = {0.2f, 0.3f, 0};
    light.intensity = Rgb(3);
    scene.lights.push_back(light);
    const auto box = tiny::ready(std::move(scene));
    CHECK(noise_of(*box->render, GatherSharing::neighbours) <
          0.97 * noise_of(*box->render, GatherSharing::none)); // the rest is of photons
}

TEST_CASE("shared gathers: a part of the image has the bits of the whole, by however many threads",
          "[integrator]")
{
    const auto room = tiny::ready(tiny::room());
    const PassImages whole = third_pass(*room->render, {}, 1);
    CHECK(mean_of(whole.radiance) > 0);
    CHECK(third_pass(*room->render, {}, 7).radiance.pixels == whole.radiance.pixels);
    for (const PixelRect& crop : {PixelRect{17, 5, 30, 20}, PixelRect{3, 14, 4, 15}}) {
        const Image part = third_pass(*room->render, crop, 2).radiance;
        int others = 0;
        for (int y = crop.y0; y < crop.y1; ++y)
            for (int x = crop.x0; x < crop.x1; ++x)
                others += part.at(x - crop.x0, y - crop.y0) != whole.radiance.at(x, y) ? 1 : 0;
        CHECK(others == 0);
    }
}
