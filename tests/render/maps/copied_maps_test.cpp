#include "common/math/random.h"
#include "common/math/sampling.h"
#include "common/partition/expand_copies.h"
#include "common/rays/surface_point.h"
#include "preprocess/partition/build_partition.h"
#include "render/maps/estimate.h"
#include "render/maps/gather.h"
#include "tests/support/copied_mesh.h"

#include <catch2/catch.hpp>

using namespace hipmap;
using tiny::place_at;

namespace {

/// Boxes that stand on a floor, and cut through each other.
TriangleMesh boxes()
{
    TriangleMesh floor =
        tiny::make_mesh({{-1, 0, -1}, {-1, 0, 1}, {1, 0, 1}, {1, 0, -1}}, {{0, 1, 2}, {0, 2, 3}});
    TriangleMesh box = tiny::cube();
    for (glm::vec3& p : box.positions)
        p = 0.2f * p + glm::vec3(-0.7f, 0.1f, -0.7f);
    return tiny::with_copies(floor, box,
                             {place_at({0.6, 0, 0.1}, 20), place_at({0.15, 0.03, 0.02}, 11, 1.1),
                              place_at({1.2, 0, 1}, 70, 0.6), place_at({0, 0.4, 1.2}, 33)});
}

struct Both {
    Scene scene;
    Partition partition;
    Scene stored_scene;
    Partition stored_partition;
};

Both both()
{
    Both out;
    out.scene = tiny::make_scene(boxes());
    out.partition = build_partition_of_copies(out.scene, {}).partition;
    out.stored_scene = out.scene;
    out.stored_partition = expand_copies(out.partition, out.scene.mesh);
    store_copies(out.stored_scene.mesh);
    return out;
}

struct Sample {
    SurfacePoint at;
    std::uint64_t number;
};

/// Points on faces: many on each, whatever its size.
std::vector<Sample> points_on(const TriangleMesh& mesh, std::uint64_t of_each)
{
    std::vector<Sample> out;
    for (FaceId face = 0; face < mesh.all_face_count(); ++face)
        for (std::uint64_t i = 0; i < of_each; ++i) {
            RandomSequence random(3, RandomStream::photons, face, i);
            out.push_back({surface_point(mesh, face, sample_triangle(random.next2())), i});
        }
    return out;
}

std::vector<Photon> photons_on(const TriangleMesh& mesh, const Partition& partition)
{
    std::vector<Photon> out;
    for (const Sample& sample : points_on(mesh, 60)) {
        RandomSequence random(4, RandomStream::photons, sample.at.face, sample.number);
        const auto side = static_cast<std::uint8_t>(partition.is_flipped(sample.at.face) ? 1 : 0);
        out.push_back({sample.at.position, Rgb(0.5f + random.next()), sample.at.geometric_normal,
                       sample.at.face, side});
    }
    return out;
}

} // namespace

TEST_CASE("maps of copies: areas, normals and estimates are those of stored faces",
          "[maps][copies]")
{
    const Both sample = both();
    REQUIRE(sample.partition.copies.size() == 4);
    REQUIRE_FALSE(sample.partition.own_contacts.empty());
    const MapSurfaces copied(sample.scene.mesh, sample.partition);
    const MapSurfaces stored(sample.stored_scene.mesh, sample.stored_partition);
    const std::vector<Photon> photons = photons_on(sample.scene.mesh, sample.partition);
    const PhotonMaps maps = build_photon_maps(photons, sample.partition, {20});
    const PhotonMaps stored_maps = build_photon_maps(photons, sample.stored_partition, {20});
    CHECK(maps.maps.size() == stored_maps.maps.size());
    EstimateScratch scratch, stored_scratch;
    int differ = 0, count = 0, near = 0;
    for (const Sample& point : points_on(sample.scene.mesh, 25)) {
        const FaceId face = point.at.face;
        CHECK(copied.area_at(face) == Approx(stored.area_at(face)).epsilon(1e-4));
        CHECK(glm::dot(copied.normal(face), stored.normal(face)) > 0.99999f);
        const std::uint8_t side = sample.partition.is_flipped(face) ? 1 : 0;
        PhotonQuery query{point.at.position, copied.normal(face), face, side};
        query.radius = 0.15f;
        const float a = estimate_irradiance(maps, copied, query, scratch).y;
        const float b = estimate_irradiance(stored_maps, stored, query, stored_scratch).y;
        near += scratch.near_boundary ? 1 : 0;
        ++count;
        differ += std::abs(a - b) > 1e-3f * std::abs(b) ? 1 : 0; // a photon on the very edge
    }
    CHECK(near > count / 4);
    CHECK(differ <= count / 100);
}

TEST_CASE("maps of copies: what is visible from a point is what it is with stored faces",
          "[maps][copies]")
{
    const Both sample = both();
    const MapSurfaces copied(sample.scene.mesh, sample.partition);
    const MapSurfaces stored(sample.stored_scene.mesh, sample.stored_partition);
    EstimateScratch a, b;
    for (const Sample& point : points_on(sample.scene.mesh, 40))
        for (const float radius : {0.02f, 0.1f, 0.5f}) {
            PhotonQuery query{point.at.position, copied.normal(point.at.face), point.at.face, 0};
            const float seen = look_around(copied, query, radius, a);
            REQUIRE(seen == look_around(stored, query, radius, b));
            CHECK(a.disc.area(radius) == Approx(b.disc.area(radius)).epsilon(1e-3));
        }
}

TEST_CASE("photon maps: few photons in very many maps take no memory for the empty ones",
          "[maps][copies]")
{
    std::vector<Similarity> places;
    for (int i = 0; i < 120'000; ++i)
        places.push_back(place_at({i % 400, 0, i / 400}));
    Scene scene = tiny::make_scene(tiny::with_copies(tiny::quad(), tiny::cube(), places));
    for (FaceCopy& copy : scene.mesh.copies)
        copy.place.move *= 4;
    const Partition partition = build_partition_of_copies(scene, {}).partition;
    REQUIRE(partition.all_map_count() > 700'000);
    std::vector<Photon> photons;
    for (FaceId i = 0; i < 3000; ++i) {
        const FaceId face = i * 479 % static_cast<FaceId>(scene.mesh.all_face_count());
        photons.push_back({scene.mesh.triangle(face)[0],
                           Rgb(1),
                           {0, 0, 1},
                           face,
                           static_cast<std::uint8_t>(i % 2)});
    }
    const PhotonMaps maps = build_photon_maps(photons, partition, {5});
    CHECK(maps.map_of.empty());
    CHECK(maps.bytes() < 3'000'000);
    std::size_t found = 0;
    for (const Photon& photon : photons) {
        const PhotonMap* map = maps.map_at(partition.map_of(photon.face), photon.side);
        REQUIRE(map != nullptr);
        CHECK(map->side == photon.side);
        found += std::ranges::count(map->faces, photon.face) > 0 ? 1 : 0;
    }
    CHECK(found == photons.size());
    std::size_t held = 0;
    for (const PhotonMap& map : maps.maps)
        held += map.tree.size;
    CHECK(held == photons.size());
    CHECK(maps.place(partition.all_map_count() - 1, 0) != 0);
}
