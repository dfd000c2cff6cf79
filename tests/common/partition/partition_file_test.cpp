#include "common/file/output_file.h"
#include "common/input_error.h"
#include "common/partition/check_partition.h"
#include "common/partition/partition_file.h"
#include "tests/support/overwrite.h"
#include "tests/support/tiny_meshes.h"

#include <catch2/catch.hpp>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <functional>
#include <limits>
#include <span>

using namespace hipmap;

namespace {

/// A folder that goes away with its files.
struct TemporaryFolder {
    std::filesystem::path path = std::filesystem::temp_directory_path() /
                                 ("hipmap_partition_test_" + std::to_string(::getpid()));

    TemporaryFolder() { std::filesystem::create_directories(path); }
    ~TemporaryFolder() { std::filesystem::remove_all(path); }
};

/// Two faces that share a map, one alone, one degenerate.
Partition sample(const Scene& scene)
{
    using enum EdgeClass;
    Partition p;
    p.scene = fingerprint(scene);
    p.angle_threshold = 0.5;
    p.map_count = 2;
    p.map_of_face = {0, 0, 1, kNone};
    p.edge_class = {connected, unconnected, border,       connected,  border,     border,
                    border,    unconnected, non_manifold, degenerate, degenerate, degenerate};
    p.opposite.assign(12, kNone);
    p.opposite[0] = 3;
    p.opposite[3] = 0;
    p.opposite[1] = 7;
    p.opposite[7] = 1;
    p.flipped = {0, 1, 0, 0};
    p.closed = {1, 1, 0, 0};
    p.reach = {0.25f, 0.5f, std::numeric_limits<float>::infinity(), 0};
    p.candidate = {1, 0, 0, 0};
    p.kept_edges = {1, 7, 0, 0};
    p.self_distance = {std::numeric_limits<float>::infinity(), 0.125f, 3, 0};
    p.position_error = 1e-6f;
    p.bridged_edges = {2, 8};
    p.group_count = 1;
    p.group_of_face = {kNone, 0, kNone, kNone};
    p.group_radius = {0, 0.0625f, 0, 0};
    p.contacts = {{0, {1, 2, 3}, {4, 5, 6}}, {1, {0, 0, 0}, {0, -1, 0}}};
    return p;
}

Scene scene_of(std::uint32_t faces)
{
    return tiny::make_scene(tiny::fan(faces));
}

std::string error_of(const std::function<void()>& work)
{
    try {
        work();
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

void require_same(const Partition& read, const Partition& written)
{
    CHECK(read.scene == written.scene);
    CHECK(read.angle_threshold == written.angle_threshold);
    CHECK(read.map_count == written.map_count);
    CHECK(read.map_of_face == written.map_of_face);
    CHECK(read.edge_class == written.edge_class);
    CHECK(read.opposite == written.opposite);
    CHECK(read.flipped == written.flipped);
    CHECK(read.closed == written.closed);
    CHECK(read.reach == written.reach);
    CHECK(read.candidate == written.candidate);
    CHECK(read.kept_edges == written.kept_edges);
    CHECK(read.self_distance == written.self_distance);
    CHECK(read.position_error == written.position_error);
    CHECK(read.bridged_edges == written.bridged_edges);
    CHECK(read.contacts == written.contacts);
    CHECK(read.group_count == written.group_count);
    CHECK(read.group_of_face == written.group_of_face);
    CHECK(read.group_radius == written.group_radius);
    CHECK(read.apart == written.apart);
    CHECK(read.shared == written.shared);
    CHECK(read.copies == written.copies);
    CHECK(read.own_contacts == written.own_contacts);
    CHECK(read.first_map_of_copy == written.first_map_of_copy);
    CHECK(read.all_face_count() == written.all_face_count());
    CHECK(read.all_map_count() == written.all_map_count());
}

/// The sample with two copies of its first three faces.
Partition copied_sample(const Scene& scene)
{
    Partition p = sample(scene);
    p.apart = {1, 3};
    p.shared = {{0, 3, 0, 2}};
    p.copies = {0, 0};
    p.own_contacts = {{1, {1, 0, 3}, {4, 5, 0}}, {4, {0, 0, 0}, {0, -1, 0}}};
    index_copies(p);
    return p;
}

} // namespace

TEST_CASE("partition file: every field survives, in one chunk or in many", "[partition]")
{
    const TemporaryFolder folder;
    const Partition written = sample(scene_of(4));
    const std::filesystem::path path = folder.path / "a.hpm";
    for (const std::size_t chunk_bytes : {kChunkBytes, std::size_t{100}, std::size_t{10}}) {
        write_partition(path, written, chunk_bytes);
        require_same(read_partition(path), written);
    }
}

TEST_CASE("partition file: copies survive, in one chunk or in many", "[partition][copies]")
{
    const TemporaryFolder folder;
    const Partition written = copied_sample(scene_of(4));
    CHECK(written.all_face_count() == 10);
    CHECK(written.all_map_count() == 6);
    CHECK(written.map_of(6) == 3);
    CHECK(written.map_of(9) == 5);
    const std::filesystem::path path = folder.path / "a.hpm";
    for (const std::size_t chunk_bytes : {kChunkBytes, std::size_t{100}, std::size_t{10}}) {
        write_partition(path, written, chunk_bytes);
        require_same(read_partition(path), written);
    }
}

TEST_CASE("partition file: copies that cannot be are refused", "[partition][copies]")
{
    const TemporaryFolder folder;
    const std::filesystem::path path = folder.path / "a.hpm";
    const auto breaks = std::vector<std::function<void(Partition&)>>{
        [](Partition& p) { p.shared[0].face_count = 2; }, // a neighbour is outside
        [](Partition& p) { p.shared[0].face_count = 5; }, // beyond the last face
        [](Partition& p) { p.shared[0].face_count = 0; },
        [](Partition& p) { p.shared[0].map_count = 1; }, // a map is outside
        [](Partition& p) { p.shared[0].map_count = 3; },
        [](Partition& p) { p.shared.push_back(p.shared[0]); }, // overlaps
        [](Partition& p) { p.copies[1] = 1; },
        [](Partition& p) {
            p.apart = {3, 1};
        },
        [](Partition& p) { p.own_contacts[1].map = 6; },
        [](Partition& p) { p.own_contacts[1].map = 0; }, // out of order
        [](Partition& p) { p.own_contacts[0].a.x = std::numeric_limits<float>::infinity(); }};
    for (const auto& damage : breaks) {
        Partition p = copied_sample(scene_of(4));
        damage(p);
        write_partition(path, p);
        CHECK(error_of([&] { read_partition(path); }).find("damaged") != std::string::npos);
    }
}

TEST_CASE("partition file: chunks that are missing or too many are refused", "[partition]")
{
    const TemporaryFolder folder;
    const std::filesystem::path path = folder.path / "a.hpm";
    write_partition(path, sample(scene_of(4)), 60);
    const std::vector<std::byte> whole = read_file(path);
    std::uint32_t first = 0;
    std::memcpy(&first, whole.data(), sizeof first);
    first += sizeof first;
    REQUIRE(first < whole.size());
    overwrite(path, std::span(whole).first(first));
    CHECK(error_of([&] { read_partition(path); }).find("truncated") != std::string::npos);
    overwrite(path, std::span(whole).subspan(first));
    CHECK(error_of([&] { read_partition(path); }).find("truncated") != std::string::npos);
    std::vector<std::byte> more = whole;
    more.insert(more.end(), whole.begin(), whole.begin() + first);
    overwrite(path, more);
    CHECK(error_of([&] { read_partition(path); }).find("truncated") != std::string::npos);
}

TEST_CASE("partition file: an empty partition survives", "[partition]")
{
    const TemporaryFolder folder;
    write_partition(folder.path / "a.hpm", Partition{});
    CHECK(read_partition(folder.path / "a.hpm").face_count() == 0);
}

TEST_CASE("partition file: a truncated one is refused", "[partition]")
{
    const TemporaryFolder folder;
    const std::filesystem::path path = folder.path / "a.hpm";
    write_partition(path, sample(scene_of(4)));
    const std::vector<std::byte> whole = read_file(path);
    for (std::size_t size = 0; size < whole.size(); ++size) {
        overwrite(path, std::span(whole).first(size));
        const std::string error = error_of([&] { read_partition(path); });
        INFO(size << " of " << whole.size() << " bytes");
        REQUIRE(error.find("a.hpm: ") != std::string::npos);
        REQUIRE(error.find('\n') == std::string::npos);
    }
}

TEST_CASE("partition file: any flipped bit is refused or changes nothing", "[partition]")
{
    const TemporaryFolder folder;
    const std::filesystem::path path = folder.path / "a.hpm";
    const Partition written = sample(scene_of(4));
    write_partition(path, written);
    const std::vector<std::byte> whole = read_file(path);
    std::size_t refused = 0;
    for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
        std::vector<std::byte> damaged = whole;
        damaged[bit / 8] ^= std::byte{1} << (bit % 8);
        overwrite(path, damaged);
        try {
            const Partition read = read_partition(path); // padding was hit
            REQUIRE(read.scene == written.scene);
            REQUIRE(read.map_of_face == written.map_of_face);
            REQUIRE(read.reach == written.reach);
        } catch (const InputError&) {
            ++refused;
        }
    }
    CHECK(refused > 4 * whole.size());
}

TEST_CASE("partition file: other files are not partitions", "[partition]")
{
    const TemporaryFolder folder;
    const std::filesystem::path path = folder.path / "a.hpm";
    CHECK(error_of([&] { read_partition(path); }) != "");
    write_file(path, std::string_view("glTF, or anything else that is not a partition"));
    CHECK(error_of([&] { read_partition(path); }).find("not a partition file") !=
          std::string::npos);
    for (const std::string_view other : {std::string_view("\x10\0\0\0HPM1 of another version", 28),
                                         std::string_view("\x20\0\0\0\x10\0\0\0HPM3, too", 17)}) {
        write_file(path, other);
        CHECK(error_of([&] { read_partition(path); }).find("another version") != std::string::npos);
    }
}

TEST_CASE("partition file: values that contradict each other are refused", "[partition]")
{
    const TemporaryFolder folder;
    const std::filesystem::path path = folder.path / "a.hpm";
    const std::vector<std::function<void(Partition&)>> damages{
        [](Partition& p) { p.map_of_face[1] = 2; },
        [](Partition& p) { p.map_of_face[0] = 1; },
        [](Partition& p) { p.map_of_face[1] = 1; },
        [](Partition& p) { p.map_count = 3; },
        [](Partition& p) { p.edge_class[2] = static_cast<EdgeClass>(5); },
        [](Partition& p) { p.edge_class[0] = EdgeClass::unconnected; },
        [](Partition& p) { p.edge_class[2] = EdgeClass::degenerate; },
        [](Partition& p) { p.edge_class[2] = EdgeClass::connected; },
        [](Partition& p) { p.opposite[0] = 12; },
        [](Partition& p) { p.opposite[0] = 0; },
        [](Partition& p) { p.opposite[0] = kNone; },
        [](Partition& p) { p.opposite[2] = 5; },
        [](Partition& p) { p.opposite.pop_back(); },
        [](Partition& p) { p.flipped[0] = 2; },
        [](Partition& p) { p.closed.push_back(0); },
        [](Partition& p) { p.reach[0] = -1; },
        [](Partition& p) { p.reach[0] = std::numeric_limits<float>::quiet_NaN(); },
        [](Partition& p) { p.candidate[3] = 1; },
        [](Partition& p) { p.kept_edges[1] = 8; },
        [](Partition& p) { p.kept_edges.pop_back(); },
        [](Partition& p) { p.self_distance[0] = -1; },
        [](Partition& p) { p.self_distance[1] = std::numeric_limits<float>::quiet_NaN(); },
        [](Partition& p) { p.self_distance.pop_back(); },
        [](Partition& p) { p.position_error = -1; },
        [](Partition& p) {
            p.bridged_edges = {8, 2};
        },
        [](Partition& p) { p.bridged_edges = {0}; },
        [](Partition& p) { p.bridged_edges = {12}; },
        [](Partition& p) { p.contacts[1].map = 2; },
        [](Partition& p) { p.contacts[0].map = 1, p.contacts[1].map = 0; },
        [](Partition& p) { p.contacts[0].b.y = std::numeric_limits<float>::infinity(); },
        [](Partition& p) { p.position_error = std::numeric_limits<float>::infinity(); },
        [](Partition& p) { p.group_count = 2; },
        [](Partition& p) { p.group_of_face[1] = 1; },
        [](Partition& p) { p.group_of_face[0] = 1; },
        [](Partition& p) { p.group_of_face[2] = 0; },
        [](Partition& p) {
            p.group_of_face = {kNone, kNone, kNone, 0}, p.group_radius[1] = 0;
        },
        [](Partition& p) { p.group_of_face[1] = kNone, p.group_count = 0; },
        [](Partition& p) { p.group_of_face.pop_back(); },
        [](Partition& p) { p.group_radius[1] = -1; },
        [](Partition& p) { p.group_radius[0] = 1; },
        [](Partition& p) { p.group_radius[1] = std::numeric_limits<float>::quiet_NaN(); },
        [](Partition& p) { p.group_radius[1] = std::numeric_limits<float>::infinity(); },
        [](Partition& p) { p.group_radius.pop_back(); },
        [](Partition& p) { p.angle_threshold = 4; },
        [](Partition& p) { p.angle_threshold = std::numeric_limits<double>::quiet_NaN(); },
    };
    for (std::size_t i = 0; i < damages.size(); ++i) {
        Partition p = sample(scene_of(4));
        REQUIRE(defect_of(p) == "");
        damages[i](p);
        INFO("damage " << i);
        CHECK(defect_of(p) != "");
        write_partition(path, p);
        CHECK(error_of([&] { read_partition(path); }).find("damaged") != std::string::npos);
    }
}

TEST_CASE("partition file: a partition of another scene is refused", "[partition]")
{
    const Partition p = sample(scene_of(4));
    CHECK(error_of([&] { check_partition_of(p, scene_of(4), "desk.hpm"); }) == "");
    CHECK(error_of([&] { check_partition_of(p, scene_of(7), "desk.hpm"); }) ==
          "desk.hpm: made for another scene (4 faces, the scene has 7); "
          "run preprocess on this scene again");
    Scene moved = scene_of(4);
    moved.mesh.positions[1].x += 0.5f;
    CHECK(error_of([&] {
              check_partition_of(p, moved, "desk.hpm");
          }).find("desk.hpm: made for another scene") == 0);
}

TEST_CASE("partition file: nothing is left where none can be written", "[partition]")
{
    const TemporaryFolder folder;
    const auto path = folder.path / "no_such_folder" / "a.hpm";
    CHECK(error_of([&] { write_partition(path, sample(scene_of(4))); }).find("a.hpm") !=
          std::string::npos);
    CHECK(std::filesystem::is_empty(folder.path));
}
