#include "common/math/sampling.h"
#include "render/maps/volume_map.h"
#include "render/media/phase.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_meshes.h"

#include <catch2/catch.hpp>
#include <tbb/global_control.h>

using namespace hipmap;

namespace {

/// Without faces.  Made when first asked for: before main, Embree would be the first to start TBB,
/// which then keeps Embree's way with subnormal numbers (zero) for all that runs in parallel.
const EmbreeScene& nowhere()
{
    static const EmbreeScene scene{TriangleMesh{}};
    return scene;
}

/// In the unit cube about the origin; every seventh in another medium.
std::vector<VolumePhoton> photons_of(std::size_t count, std::uint64_t seed)
{
    std::vector<VolumePhoton> out;
    for (std::uint64_t i = 0; i < count; ++i) {
        RandomSequence random(seed, RandomStream::photons, 0, i);
        const glm::vec3 p(random.next2(), random.next());
        const Rgb power(random.next2(), random.next());
        out.push_back({p - 0.5f, power, sample_sphere(random.next2()), i % 7 == 0 ? kNone : 0});
    }
    return out;
}

Medium thin()
{
    Medium out;
    out.scattering = {1, 0.5f, 2};
    out.absorption = {0, 1, 0.25f};
    out.phase = {PhaseKind::henyey_greenstein, 0.4f};
    return out;
}

MediumSegment segment_along(const glm::vec3& origin, const glm::vec3& direction, float near,
                            float far)
{
    MediumSegment out;
    out.inside = 0;
    out.ray = {origin, glm::normalize(direction), near, far};
    return out;
}

std::array<Rgb, 3> radiance_of(const VolumeMap& map, const Medium& medium,
                               const MediumSegment& segment, const BeamScales& scales)
{
    const PlacedDensity even;
    const OpticalDepth optical_depth = optical_depth_along(even, segment.ray);
    return beam_radiance(map, {medium, segment.inside, optical_depth}, scales);
}

/// docs/media.md (8), of all photons.
glm::dvec3 by_all(const VolumeMap& map, const Medium& medium, const MediumSegment& segment,
                  double scale)
{
    glm::dvec3 sum(0.0);
    for (std::size_t i = 0; i < map.photons.size(); ++i) {
        const VolumePhoton& photon = map.photons[i];
        const glm::dvec3 way = photon.position - segment.ray.origin, d = segment.ray.direction;
        const double along = glm::dot(way, d), radius = scale * map.radii[i];
        const glm::dvec3 aside = way - along * d;
        if (photon.inside != segment.inside || along < segment.ray.near ||
            along >= segment.ray.far || glm::dot(aside, aside) >= radius * radius)
            continue;
        const double phase =
            phase_value(medium.phase, float(glm::dot(glm::dvec3(photon.travel), -d)));
        sum += glm::dvec3(photon.power) *
               glm::exp(-glm::dvec3(medium.extinction()) * (along - segment.ray.near)) * phase /
               (M_PI * radius * radius);
    }
    return sum;
}

} // namespace

TEST_CASE("volume map: its tree finds the photons that a look at all of them does", "[maps][media]")
{
    constexpr BeamScales kScales = {1, 0.7f, 0.5f};
    for (const std::size_t count : {1u, 8u, 9u, 3000u}) {
        const std::vector<VolumePhoton> photons = photons_of(count, 1);
        const VolumeMap map = build_volume_map(
            photons, find_volume_radii(photons_of(count, 2), 10, 1), 0.8f, nowhere());
        REQUIRE(map.photons.size() == count);
        for (const MediumSegment& segment :
             {segment_along({-1, 0.1f, 0.2f}, {1, 0, 0}, 0.5f, 1.5f),
              segment_along({0, 0, 0}, {0.3f, -0.2f, 1}, 0, 0.3f),
              segment_along({-2, -2.1f, -1.9f}, {1, 1, 1}, 0.1f, 9)}) {
            const auto found = radiance_of(map, thin(), segment, kScales);
            for (std::size_t i = 0; i < found.size(); ++i) {
                const glm::dvec3 all = by_all(map, thin(), segment, kScales[i]);
                for (int c = 0; c < 3; ++c)
                    CHECK(found[i][c] == Approx(all[c]).epsilon(1e-4));
            }
        }
    }
}

TEST_CASE("volume map: photons spread evenly have the radiance of their density", "[maps][media]")
{
    constexpr std::size_t kPhotons = 2000;
    Medium medium = thin();
    medium.phase = {};
    const MediumSegment segment = segment_along({0, 0, -0.5f}, {0, 0, 1}, 0, 1);
    const VolumeRadii radii = find_volume_radii(photons_of(kPhotons, 99), 8, 1);
    std::array<RunningMean, 3> found;
    for (std::uint64_t seed = 100; seed < 200; ++seed) {
        std::vector<VolumePhoton> photons = photons_of(kPhotons, seed);
        for (VolumePhoton& photon : photons) {
            photon.power = Rgb(1);
            photon.inside = 0;
        }
        const auto radiance = radiance_of(build_volume_map(photons, radii, 1, nowhere()), medium,
                                          segment, {1, 0.7f, 0.5f});
        for (std::size_t i = 0; i < found.size(); ++i)
            found[i].add(radiance[i].x);
    }
    for (const RunningMean& by_scale : found) // extinction 1
        CHECK(std::abs(by_scale.z_score(kPhotons / (4 * M_PI) * (1 - std::exp(-1.0)))) < kMostZ);
}

TEST_CASE("volume map: no light is lost where discs reach out of a slab", "[maps][media]")
{
    constexpr int kPhotons = 4000;
    Medium medium;
    medium.scattering = Rgb(1e-6f); // nothing is lost on the way
    const EmbreeScene faces(tiny::make_mesh({{-9, -0.5f, -9},
                                             {9, -0.5f, -9},
                                             {0, -0.5f, 18},
                                             {-9, 0.5f, -9},
                                             {9, 0.5f, -9},
                                             {0, 0.5f, 18}},
                                            {{0, 1, 2}, {3, 4, 5}}));
    for (const glm::vec3& direction : {glm::vec3(1, 0, 0), glm::normalize(glm::vec3(1, 1, 0.2f))}) {
        RunningMean found;
        for (std::uint64_t seed = 0; seed < 30; ++seed) {
            std::vector<VolumePhoton> photons = photons_of(kPhotons, seed);
            for (VolumePhoton& photon : photons) {
                photon.position *= glm::vec3(6, 1, 3);
                photon.power = Rgb(1);
                photon.inside = 0;
            }
            VolumeRadii radii;
            radii.widest = 0.3f;
            const VolumeMap map = build_volume_map(photons, radii, 1, faces);
            for (std::uint64_t i = 0; i < 50; ++i) {
                RandomSequence random(7, RandomStream::pictures, seed, i);
                const float height = direction.y > 0 ? 0 : random.next() - 0.5f;
                const glm::vec3 at(random.next() - 0.5f, height, random.next() - 0.5f);
                const float half = direction.y > 0 ? 0.5f / direction.y : 1;
                const MediumSegment segment = segment_along(at, direction, -half, half);
                found.add(radiance_of(map, medium, segment, {1, 0.7f, 0.5f})[0].x / (2 * half));
            }
        }
        CHECK(std::abs(found.z_score(kPhotons / 18.0 / (4 * M_PI))) < kMostZ);
        CHECK(found.standard_error() < 0.01 * found.mean());
    }
}

TEST_CASE("volume radii: where the k-th photon is, and widest without photons", "[maps][media]")
{
    const std::vector<VolumePhoton> pilot = photons_of(500, 3);
    const VolumeRadii radii = find_volume_radii(pilot, 10, 2);
    for (std::uint32_t slot = 0; slot < radii.radius.size(); slot += 11) {
        const glm::vec3 at = radii.tree.position(slot);
        const auto within = std::count_if(pilot.begin(), pilot.end(), [&](const VolumePhoton& p) {
            return glm::distance(p.position, at) <= radii.radius[slot] * (1 + 1e-5f);
        });
        CHECK(within == 10);
        CHECK(volume_radius_at(radii, at) == Approx(radii.radius[slot]));
    }
    CHECK(volume_radius_at(radii, {50, 0, 0}) == 2);
    CHECK(volume_radius_at(find_volume_radii({}, 10, 2), {0, 0, 0}) == 2);
    CHECK(volume_radius_at(find_volume_radii(photons_of(3, 1), 10, 2), {0, 0, 0}) == 2);
    CHECK(build_volume_map({}, radii, 1, nowhere()).nodes.empty());
}

TEST_CASE("volume map: the same at any number of threads", "[maps][media]")
{
    const std::vector<VolumePhoton> photons = photons_of(20000, 5);
    const auto build = [&] {
        return build_volume_map(photons, find_volume_radii(photons, 12, 1), 1, nowhere());
    };
    const VolumeMap many = build();
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const VolumeMap alone = build();
    CHECK(many.radii == alone.radii);
    CHECK(std::equal(many.photons.begin(), many.photons.end(), alone.photons.begin(),
                     [](const VolumePhoton& a, const VolumePhoton& b) {
                         return a.position == b.position && a.power == b.power;
                     }));
}
