#include "common/math/sampling.h"
#include "render/integrator/path_tracer.h"
#include "render/lights/emission.h"
#include "render/photons/trace_photons.h"
#include "tests/support/form_factor.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

/// A floor under a square light, of side 0.4 and 0.3 above it, whose half to x > 0 alone emits.
Scene half_lit_floor()
{
    Scene scene = tiny::diffuse_floor();
    const std::size_t first = scene.mesh.positions.size();
    tiny::add(scene, tiny::floor_at(0.3f, -0.4f), tiny::emissive(Rgb(2)));
    std::vector<glm::vec2>& uv = scene.mesh.attributes.uv[0];
    for (const glm::vec3& p : scene.mesh.positions)
        uv.emplace_back(p.x > 0 ? 1 : 0, 0.5f);
    REQUIRE(uv.size() == first + 4);
    scene.images.push_back({"halves", 2, 1, {0, 0, 0, 255, 255, 255, 255, 255}});
    TextureSlot slot;
    slot.use = TextureUse::emission;
    slot.sampler.magnify = Filter::nearest;
    slot.sampler.srgb = true;
    scene.materials[1].textures = {slot};
    return scene;
}

constexpr double kRadiance = 2, kHalf = 0.2, kLampHeight = 0.3;

} // namespace

TEST_CASE("emissive textures: the floor has the light of the half that emits", "[integrator]")
{
    const auto ready = tiny::ready(half_lit_floor());
    Ray ray;
    ray.origin = {0, 0.1f, 0};
    ray.direction = {0, -1, 0};
    RunningMean mean;
    for (std::uint64_t i = 0; i < 40000; ++i) {
        RandomSequence random(23, RandomStream::eye_paths, 0, i);
        mean.add(trace_path(*ready->render, ray, random).y);
    }
    // Two of the four squares around the point above.
    const double irradiance = kRadiance * 2 * corner_rectangle(kHalf, kHalf, kLampHeight);
    CHECK(std::abs(mean.z_score(0.5 / kPi * irradiance)) < kMostZ);
    CHECK(mean.standard_error() < 0.01 * mean.mean());
}

TEST_CASE("emissive textures: light paths carry the power emitted, from there", "[integrator]")
{
    const auto ready = tiny::ready(half_lit_floor());
    const EmissionPlan plan = plan_emission(ready->render->lights, 20000, Emitters::all);
    RunningMean power;
    for (std::uint64_t i = 0; i < plan.paths; ++i) {
        RandomSequence random(5, RandomStream::photons, 0, i);
        const EmittedPath path = emit_path(ready->render->lights, share_of(plan, i), random);
        power.add(path.power.y * static_cast<double>(plan.paths));
        if (path.power.y > 0)
            CHECK(path.ray.origin.x > -1e-5f);
    }
    CHECK(std::abs(power.z_score(double{kPi} * kRadiance * 2 * kHalf * kHalf)) < kMostZ);
}

TEST_CASE("emissive textures: photons bring the floor the power emitted to it", "[integrator]")
{
    double power = 0; // of midpoints of a grid, each under a rectangle with signed corners
    constexpr int kSide = 64;
    for (int i = 0; i < kSide; ++i)
        for (int j = 0; j < kSide; ++j) {
            const double x = (i + 0.5) / kSide - 0.5, z = (j + 0.5) / kSide - 0.5;
            const auto corner = [&](double to_x, double to_z) {
                return corner_rectangle(to_x - x, to_z - z, kLampHeight);
            };
            power += kRadiance / (kSide * kSide) *
                     (corner(kHalf, kHalf) - corner(0, kHalf) - corner(kHalf, -kHalf) +
                      corner(0, -kHalf));
        }
    const auto ready = tiny::ready(half_lit_floor());
    RunningMean stored;
    for (std::uint64_t pass = 0; pass < 24; ++pass) {
        PhotonOptions options{1000, 1, pass, true};
        options.light = {false, false};
        double sum = 0;
        for (const Photon& photon : trace_photons(*ready->render, options).global)
            sum += photon.power.y;
        stored.add(sum);
    }
    CHECK(std::abs(stored.z_score(power)) < kMostZ);
    CHECK(stored.standard_error() < 0.01 * power);
}
