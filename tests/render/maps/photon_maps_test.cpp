#include "common/math/sampling.h"
#include "common/rays/surface_point.h"
#include "render/maps/photon_maps.h"
#include "tests/support/statistics.h"
#include "tests/support/tiny_scenes.h"

#include <catch2/catch.hpp>
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <cstring>

using namespace hipmap;

namespace {

std::vector<Photon> scatter_photons(const TriangleMesh& mesh, std::size_t count)
{
    std::vector<Photon> photons;
    for (std::size_t i = 0; i < count; ++i) {
        RandomSequence random(1, RandomStream::photons, 0, i);
        const auto face =
            static_cast<FaceId>(random.next() * static_cast<float>(mesh.face_count()));
        const SurfacePoint at = surface_point(mesh, face, sample_triangle(random.next2()));
        const std::uint8_t side = random.next() < 0.7f ? 0 : 1;
        photons.push_back({at.position, Rgb(random.next(), 0.01f * random.next(), 1),
                           sample_sphere(random.next2()), face, side});
    }
    return photons;
}

/// All that tells one photon from another, in an order.
using Record = std::array<float, 5>;

template <typename T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b)
{
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

bool same_bits(const PhotonMap& a, const PhotonMap& b)
{
    return a.tree.size == b.tree.size && a.tree.levels == b.tree.levels && a.side == b.side &&
           same_bytes(a.tree.blocks, b.tree.blocks) && same_bytes(a.tree.nodes, b.tree.nodes) &&
           same_bytes(a.powers.blocks, b.powers.blocks) && a.powers.nodes == b.powers.nodes &&
           a.faces == b.faces && a.directions.size() == b.directions.size();
}

} // namespace

TEST_CASE("photon maps: each photon is in the map of its surface and side, once", "[maps]")
{
    const auto ready = tiny::ready(tiny::make_scene(tiny::cube()));
    const TriangleMesh& mesh = ready->scene.mesh;
    const std::vector<Photon> photons = scatter_photons(mesh, 5000);
    const PhotonMaps maps = build_photon_maps(photons, ready->partition, {50});
    std::vector<Record> in, out;
    for (const Photon& p : photons)
        in.push_back({p.position.x, p.position.y, p.position.z, float(p.face), float(p.side)});
    for (const PhotonMap& map : maps.maps)
        for (std::uint32_t slot = 0; slot < map.tree.size; ++slot) {
            const glm::vec3 p = map.tree.position(slot);
            const FaceId face = map.faces[slot];
            out.push_back({p.x, p.y, p.z, float(face), float(map.side)});
            CHECK(maps.map_at(ready->partition.map_of_face[face], map.side) == &map);
        }
    std::sort(in.begin(), in.end());
    std::sort(out.begin(), out.end());
    CHECK(in == out);
    CHECK(maps.maps.size() == 12);
}

TEST_CASE("photon maps: at most 24 bytes a photon all told, 28 with directions", "[maps]")
{
    constexpr std::size_t kCount = 200'000;
    const auto ready = tiny::ready(tiny::make_scene(tiny::cube()));
    const std::vector<Photon> photons = scatter_photons(ready->scene.mesh, kCount);
    for (const bool directions : {false, true}) {
        const PhotonMaps maps = build_photon_maps(photons, ready->partition, {50, directions});
        const std::size_t most = directions ? 28 : 24;
        CHECK(maps.size == kCount);
        CHECK(maps.bytes() <= most * kCount);
        CHECK(maps.bytes() > (most - 2) * kCount);
    }
}

TEST_CASE("photon maps: the same powers at any thread count", "[maps]")
{
    const auto ready = tiny::ready(tiny::make_scene(tiny::cube()));
    const std::vector<Photon> photons = scatter_photons(ready->scene.mesh, 50'000);
    std::vector<PowerSum> sums;
    for (const std::size_t threads : {1, 3}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        const PhotonMaps maps = build_photon_maps(photons, ready->partition, {50});
        for (const PhotonMap& map : maps.maps)
            sums.insert(sums.end(), map.powers.nodes.begin(), map.powers.nodes.end());
    }
    const auto half = sums.begin() + static_cast<std::ptrdiff_t>(sums.size() / 2);
    CHECK(std::equal(sums.begin(), half, half, sums.end()));
}

TEST_CASE("photon maps: those whose photons did not change are taken over, with the same bits",
          "[maps]")
{
    const auto ready = tiny::ready(tiny::make_scene(tiny::cube()));
    const Partition& partition = ready->partition;
    const std::vector<Photon> before = scatter_photons(ready->scene.mesh, 6000);
    // One more photon, in front of all, changes its own map alone.
    std::vector<Photon> after = before;
    after.insert(after.begin(), before.back());
    after.front().power *= 0.5f;
    PhotonMaps first;
    const PhotonMaps old = build_photon_maps(before, partition, {50}, &first);
    CHECK(old.taken_over == 0);
    CHECK(old.contents.size() == old.maps.size());
    for (const bool more : {false, true}) {
        const std::vector<Photon>& photons = more ? after : before;
        PhotonMaps previous = old;
        const PhotonMaps taken = build_photon_maps(photons, partition, {50}, &previous);
        const PhotonMaps built = build_photon_maps(photons, partition, {50});
        CHECK(built.contents.empty());
        CHECK(taken.taken_over == built.maps.size() - (more ? 1 : 0));
        REQUIRE(taken.maps.size() == built.maps.size());
        for (std::size_t m = 0; m < built.maps.size(); ++m)
            CHECK(same_bits(taken.maps[m], built.maps[m]));
    }
    // Another unit of power, and other things that are kept of a photon.
    after = before;
    after.front().power *= 2.0f;
    PhotonMaps previous = old;
    CHECK(build_photon_maps(after, partition, {50}, &previous).taken_over == 0);
    CHECK(build_photon_maps(before, partition, {50, true}, &previous).taken_over == 0);
}

TEST_CASE("photon powers: each node has the sum of its photons", "[maps]")
{
    for (const std::size_t count : {1, 16, 17, 256, 257, 5000, 70'000}) {
        std::vector<Photon> photons;
        std::vector<TreePoint> points;
        for (std::size_t i = 0; i < count; ++i) {
            RandomSequence random(2, RandomStream::photons, 0, i);
            const glm::vec3 at(random.next2(), 0);
            photons.push_back({at, Rgb(random.next(), random.next(), 1), {0, 0, 1}, 0, 0});
            points.push_back({at, static_cast<std::uint32_t>(i)});
        }
        const WideTree tree = build_wide_tree(points);
        const PhotonPowers powers = build_powers(tree, points, photons, power_scale(photons));
        REQUIRE(powers.nodes.size() == tree.nodes.size());
        for (std::uint32_t level = 0; level < tree.levels; ++level) {
            const std::size_t end =
                level + 1 < tree.levels ? tree.first_node[level + 1] : tree.nodes.size();
            for (std::size_t node = tree.first_node[level]; node < end; ++node) {
                const TreeNode below{level, node - tree.first_node[level]};
                const auto first = static_cast<std::uint32_t>(first_slot(tree, below));
                PowerSum sum(0);
                for (std::uint32_t i = 0; i < photons_below(tree, below); ++i)
                    sum += powers.of(first + i);
                CHECK(powers.nodes[node] == sum);
            }
        }
    }
}

TEST_CASE("round_power: unbiased for one power that comes many times", "[maps]")
{
    const std::vector<Photon> photons{{{}, Rgb(1, 3, 0.25f), {0, 0, 1}, 0, 0}};
    const PowerScale scale = power_scale(photons);
    for (const double part : {1.0, 0.7, 0.123, 1e-3, 1e-5, 3e-7}) {
        const Rgb power = photons[0].power * static_cast<float>(part);
        std::array<RunningMean, 3> means;
        bool varied = false;
        for (std::uint64_t number = 0; number < 200'000; ++number) {
            const auto rounded = round_power(power, scale, number);
            for (int channel = 0; channel < 3; ++channel)
                means[channel].add(rounded[channel]);
            varied = varied || rounded != round_power(power, scale, 0);
        }
        for (int channel = 0; channel < 3; ++channel) {
            const double truth = double{power[channel]} / scale.unit[channel];
            CHECK(std::abs(means[channel].mean() - truth) <=
                  kMostZ * means[channel].standard_error() + 1e-6);
        }
        CHECK(varied == (part < 1));
    }
}

TEST_CASE("round_power: the largest fits, and what is no power is none", "[maps]")
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    const std::vector<Photon> photons{{{}, Rgb(1e-42f, 3e38f, 0), {0, 0, 1}, 0, 0},
                                      {{}, Rgb(0, 1, 0), {0, 0, 1}, 0, 0},
                                      {{}, Rgb(infinity), {0, 0, 1}, 0, 0}};
    const PowerScale scale = power_scale(photons);
    for (std::uint64_t number = 0; number < 1000; ++number) {
        const auto largest = round_power(photons[0].power, scale, number);
        CHECK(largest[0] >= 65533);
        CHECK(largest[1] >= 65533);
        CHECK(largest[2] == 0);
        const auto none = round_power(Rgb(nan, -1, infinity), scale, number);
        CHECK(none == std::array<std::uint16_t, 3>{0, 0, 0});
    }
    CHECK(power_scale({}).unit == glm::dvec3(0));
}

TEST_CASE("packed direction: within 1e-4 of the direction", "[maps]")
{
    double most = 0;
    for (std::uint64_t i = 0; i < 100'000; ++i) {
        RandomSequence random(3, RandomStream::photons, 0, i);
        glm::vec3 direction = sample_sphere(random.next2());
        if (i < 27) // axes and diagonals
            direction = glm::vec3(i % 3, i / 3 % 3, i / 9) - 1.0f;
        direction = i == 13 ? glm::vec3(1, 0, 0) : glm::normalize(direction);
        const glm::vec3 back = unpack_direction(pack_direction(direction));
        most = std::max(most, double{glm::distance(direction, back)});
    }
    CHECK(most < 1e-4);
    CHECK(most > 1e-6);
}
