#include "render/integrator/integrators.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>

using namespace hipmap;

namespace {

Material see_through(Material material, float alpha)
{
    material.alpha_mode = AlphaMode::blend;
    material.alpha = alpha;
    return material;
}

/// Reflects a half and emits with the other, so that its radiance is one where that of all is.
Material half_emissive()
{
    Material half = tiny::diffuse(Rgb(0.5f));
    half.emission = Rgb(0.5f);
    half.double_sided = true;
    return half;
}

/// A floor under a light, seen from between them.
Scene lit_floor()
{
    Scene scene = tiny::diffuse_floor();
    ScenePointLight light;
    light.position = {0, 0.3f, 0};
    light.intensity = Rgb(1);
    scene.lights.push_back(light);
    scene.cameras[0].position = {0, 0.1f, 0};
    scene.cameras[0].forward = {0, -1, 0};
    scene.cameras[0].right = {1, 0, 0};
    scene.cameras[0].up = {0, 0, -1};
    return scene;
}

/// Of the last four vertices, which span a square: bars and holes in turn, as wide as each other.
void cut_bars(Scene& scene)
{
    std::vector<glm::vec2>& uv = scene.mesh.attributes.uv[0];
    uv.assign(scene.mesh.positions.size(), glm::vec2(0));
    std::copy_n(std::array<glm::vec2, 4>{{{0, 0}, {0, 1}, {1, 1}, {1, 0}}}.begin(), 4,
                uv.end() - 4);
    TextureImage bars{"bars", 32, 1, {}};
    for (int i = 0; i < 32; ++i)
        for (const int c : {255, 255, 255, i % 2 == 0 ? 255 : 0})
            bars.rgba.push_back(static_cast<std::uint8_t>(c));
    scene.images.push_back(bars);
    TextureSlot slot;
    slot.sampler.magnify = Filter::nearest;
    scene.materials.back().textures = {slot};
    scene.materials.back().alpha_mode = AlphaMode::mask;
}

/// A box of radiance one inside, and a sheet in it that sends on and stops a half of all light.
Scene sheet_in_even_light(const Material& sheet)
{
    TriangleMesh walls = tiny::cube();
    tiny::turn_inside_out(walls);
    Scene scene = tiny::make_scene(walls);
    scene.materials[0] = half_emissive();
    tiny::add(scene, tiny::floor_at(-0.1f, 0.7f), sheet);
    scene.cameras[0].position = {0, 0, 0.48f};
    scene.cameras[0].tan_half_height = 0.8f;
    return scene;
}

RunningMean render(const Scene& scene, Integrator integrator, std::uint64_t passes)
{
    const auto ready = tiny::ready(scene);
    RenderOptions options;
    options.integrator = integrator;
    options.width = options.height = 16;
    options.photons = 4000;
    options.samples = 4;
    options.dissertation.mode = MapMode::shared;
    RenderStatistics ignored;
    const PassSource source = make_pass_source(*ready->render, options, ignored);
    RunningMean out;
    for (std::uint64_t pass = 0; pass < passes; ++pass)
        out.add(mean_of(source.render(pass, {}).images.radiance));
    return out;
}

} // namespace

TEST_CASE("alpha: black walls let their share of a light's radiance pass", "[integrator]")
{
    Scene scene = lit_floor();
    const RunningMean bare = render(scene, Integrator::path, 8);
    tiny::add(scene, tiny::floor_at(0.2f, 0.6f), see_through(tiny::diffuse(Rgb(0)), 0.5f));
    const RunningMean one = render(scene, Integrator::path, 8);
    CHECK(std::abs(one.z_score(0.5 * bare.mean())) < kMostZ);
    CHECK(one.standard_error() < 0.02 * bare.mean());
    tiny::add(scene, tiny::floor_at(0.22f, 0.6f), see_through(tiny::diffuse(Rgb(0)), 0.2f));
    const RunningMean two = render(scene, Integrator::direct, 8);
    CHECK(std::abs(two.z_score(0.4 * bare.mean())) < kMostZ);
}

TEST_CASE("alpha: a see-through sheet that sends on as much as it stops is not seen in even light",
          "[integrator]")
{
    const Scene scene = sheet_in_even_light(see_through(half_emissive(), 0.3f));
    for (const Integrator integrator : {Integrator::path, Integrator::progressive}) {
        const RunningMean mean = render(scene, integrator, 24);
        CHECK(std::abs(mean.z_score(1)) < kMostZ);
        CHECK(mean.standard_error() < 0.005);
    }
}

TEST_CASE("alpha: the edges of holes do not darken what is beside them", "[integrator]")
{
    Scene scene = sheet_in_even_light(half_emissive());
    cut_bars(scene);
    for (const Integrator integrator : {Integrator::direct, Integrator::progressive}) {
        const RunningMean mean = render(scene, integrator, 24);
        CHECK(std::abs(mean.z_score(1)) < kMostZ);
        CHECK(mean.standard_error() < 0.005);
    }
}

TEST_CASE("alpha: photons lie as densely where light passes as where it is stopped", "[integrator]")
{
    const bool masked = GENERATE(false, true);
    const double stopped = masked ? 0.5 : 0.25;
    Scene scene = tiny::diffuse_floor();
    tiny::add(scene, tiny::floor_at(0.2f, 0.4f), tiny::diffuse(Rgb(0.5f)));
    if (masked)
        cut_bars(scene);
    else
        scene.materials.back() = see_through(scene.materials.back(), 0.25f);
    SceneSunLight sun;
    sun.direction = {0, -1, 0};
    sun.irradiance = Rgb(3);
    scene.lights.push_back(sun);
    const auto ready = tiny::ready(scene);
    RunningMean on_sheet, on_floor;
    for (std::uint64_t pass = 0; pass < 16; ++pass) {
        PhotonOptions options{2000, 1, pass, true};
        options.light = {false, false};
        double sheet = 0, floor = 0;
        for (const Photon& photon : trace_photons(*ready->render, options).global)
            (photon.face < 2 ? floor : sheet) += photon.power.y;
        on_sheet.add(sheet);
        on_floor.add(floor);
    }
    CHECK(std::abs(on_sheet.z_score(3 * 0.16)) < kMostZ);
    CHECK(std::abs(on_floor.z_score(3 * (1 - 0.16 * stopped))) < kMostZ);
}

TEST_CASE("alpha: a mask has holes where its texture is below the cutoff", "[integrator]")
{
    // Alpha rises from 0.2 on the left half to 0.8 on the right one.
    Scene scene = tiny::make_scene(tiny::quad());
    scene.mesh.attributes.uv[0] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    scene.images.push_back({"halves", 2, 1, {255, 255, 255, 51, 255, 255, 255, 204}});
    Material& material = scene.materials[0];
    TextureSlot slot;
    slot.sampler.magnify = Filter::nearest;
    material.textures = {slot};
    material.alpha_mode = AlphaMode::mask;
    const auto stops_at = [&](float x) {
        Ray ray;
        ray.origin = {x, 0.4f, 1};
        ray.direction = {0, 0, -1};
        return tiny::ready(scene)->render->rays.occluded(ray);
    };
    CHECK_FALSE(stops_at(0.499f));
    CHECK(stops_at(0.501f));
    material.alpha_cutoff = 0.1f;
    CHECK(stops_at(0.25f));
    material.alpha = 0.4f; // times 0.2 is below
    CHECK_FALSE(stops_at(0.25f));
    material.alpha_mode = AlphaMode::opaque;
    CHECK(stops_at(0.25f));
    CHECK_FALSE(tiny::ready(scene)->render->opacity);
}
