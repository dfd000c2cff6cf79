#include "render/maps/fixed_radius.h"
#include "render/maps/gather.h"
#include "render/maps/seen_photons.h"
#include "tests/render/maps/flat_walls.h"
#include "tests/render/maps/within_by_hand.h"
#include "tests/support/instruction_sets.h"

#include <numeric>

using namespace hipmap;

TEST_CASE("kernels: directions unpacked together have the bits of those unpacked one by one",
          "[maps]")
{
    std::vector<PackedDirection> packed;
    for (std::uint64_t i = 0; i < 5000; ++i) {
        RandomSequence random(4, RandomStream::photons, 0, i);
        packed.push_back(pack_direction(sample_sphere(random.next2())));
    }
    packed[0] = {0, 0}, packed[1] = {-32767, 32767}, packed[2] = {32767, 0};
    std::vector<std::uint32_t> slots(packed.size());
    std::iota(slots.rbegin(), slots.rend(), 0u);
    with_each_instruction_set([&] {
        std::size_t different = 0, size = 1;
        for (std::size_t first = 0; first + kBatch <= slots.size(); first += size) {
            size = size % kBatch + 1;
            DirectionBatch out;
            unpack_directions(packed, std::span(slots).subspan(first, size), out);
            for (std::size_t i = 0; i < size; ++i)
                different += out.at(i) == unpack_direction(packed[slots[first + i]]) ? 0 : 1;
        }
        CHECK(different == 0);
    });
}

TEST_CASE("kernels: sums by radius have the bits of plain ones in the order of the photons",
          "[maps]")
{
    const auto ready = tiny::ready(tiny::make_scene(tiny::uv_sphere(12, 8)));
    const MapSurfaces surfaces(ready->scene.mesh, ready->partition);
    const PhotonMaps maps =
        build_photon_maps(within::make_photons(ready->scene.mesh, 3000, 5), ready->partition, {50});
    const PhotonMap& map = maps.maps[0];
    std::vector<std::uint32_t> slots;
    for (std::uint32_t slot = 0; slot < map.tree.size; slot += 3)
        slots.push_back(slot);
    const PhotonQuery query{map.tree.position(slots[7]), {0, 0, 1}, map.faces[slots[7]], map.side};
    const RadiusQuery wanted{maps.power_scale, surfaces, query, {1.1f, 0.7f, 0.2f}};
    for (const bool tilted : {false, true}) {
        std::array<glm::dvec3, 3> plain{};
        for (const std::uint32_t slot : slots) {
            const glm::vec3 way = map.tree.position(slot) - query.position;
            const glm::dvec3 power(map.powers.of(slot));
            const double turned = tilted ? facing({map, slot}, query, surfaces) : 1;
            for (std::size_t r = 0; r < plain.size(); ++r)
                if (glm::dot(way, way) <= wanted.radii[r] * wanted.radii[r])
                    plain[r] += turned * power;
        }
        CHECK(plain[0].x > plain[1].x);
        CHECK(plain[2].x > 0);
        with_each_instruction_set([&] {
            SumsByRadius sums;
            for_each_batch(slots, [&](std::span<const std::uint32_t> batch) {
                add_photons(map, batch, wanted, tilted, sums);
            });
            for (std::size_t r = 0; r < plain.size(); ++r)
                CHECK(sums.at(r) == plain[r]);
        });
    }
}

TEST_CASE("kernels: photons past few and many walls are seen as they are one by one", "[maps]")
{
    flat_walls::Random random(12);
    std::vector<VisibleDisc> discs;
    for (const int walls : {0, 1, 2, 3, 5, 8, 13, 30, 60})
        discs.push_back(flat_walls::look(flat_walls::flat_query(0, 0, 1),
                                         flat_walls::random_segments(random, walls)));
    with_each_instruction_set([&] {
        std::size_t different = 0, seen = 0, hidden = 0;
        for (const VisibleDisc& disc : discs)
            for (std::size_t count = 1; count <= PhotonPlaces::kMost; ++count) {
                PhotonPlaces photons;
                for (std::size_t i = 0; i < count; ++i)
                    photons.add({random.between(-1, 1), random.between(-1, 1),
                                 random.between(-0.5f, 0.5f)}); // some beyond the fold
                const std::uint64_t found = seen_photons(disc, photons);
                for (std::size_t i = 0; i < count; ++i) {
                    const bool sees =
                        disc.sees({photons.of[0][i], photons.of[1][i], photons.of[2][i]});
                    ++(sees ? seen : hidden);
                    different += (found >> i & 1) == std::uint64_t{sees} ? 0 : 1;
                }
            }
        CHECK(different == 0);
        CHECK(seen > 1000);
        CHECK(hidden > 1000);
    });
}
