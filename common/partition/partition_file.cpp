#include "common/partition/partition_file.h"

#include "common/file/output_file.h"
#include "common/input_error.h"
#include "common/partition/check_partition.h"
#include "common/partition/partition_generated.h"

#include <flatbuffers/flatbuffers.h>
#include <xxhash.h>

#include <array>
#include <cstring>
#include <memory>
#include <new>
#include <span>
#include <string>

namespace hipmap {
namespace {

constexpr std::uint32_t kVersion = 3;

/// FlatBuffers offsets are 31 bits, and its Release builder writes past them without a word.
constexpr std::size_t kMaxBytes = std::size_t{1} << 30;

struct FreeState {
    void operator()(XXH3_state_t* state) const { XXH3_freeState(state); }
};

/// Copies one array of the file; an absent one is empty.
template <typename T, typename Stored>
void copy_array(std::vector<T>& to, const flatbuffers::Vector<Stored>* from)
{
    static_assert(sizeof(T) == sizeof(Stored));
    if (!from)
        return;
    to.resize(from->size());
    if (!to.empty())
        std::memcpy(to.data(), from->data(), to.size() * sizeof(T));
}

/// Contacts lie in two arrays of the file; arrays that do not fit each other give none.
void unpack_contacts(std::vector<MapContact>& contacts, const file::Partition& stored)
{
    std::vector<MapId> maps;
    std::vector<float> points;
    copy_array(maps, stored.contact_map());
    copy_array(points, stored.contact_points());
    if (points.size() != 6 * maps.size())
        return;
    for (std::size_t i = 0; i < maps.size(); ++i) {
        const float* p = &points[6 * i];
        contacts.push_back({maps[i], {p[0], p[1], p[2]}, {p[3], p[4], p[5]}});
    }
}

Partition unpack(const file::Partition& stored)
{
    Partition p;
    p.scene.words = {stored.scene_0(), stored.scene_1()};
    p.angle_threshold = stored.angle_threshold();
    p.map_count = stored.map_count();
    copy_array(p.map_of_face, stored.map_of_face());
    copy_array(p.edge_class, stored.edge_class());
    copy_array(p.opposite, stored.opposite());
    copy_array(p.flipped, stored.flipped());
    copy_array(p.closed, stored.closed());
    copy_array(p.reach, stored.reach());
    copy_array(p.candidate, stored.candidate());
    copy_array(p.kept_edges, stored.kept_edges());
    copy_array(p.self_distance, stored.clearance());
    p.position_error = stored.position_error();
    copy_array(p.bridged_edges, stored.bridged_edges());
    unpack_contacts(p.contacts, stored);
    p.group_count = stored.group_count();
    copy_array(p.group_of_face, stored.group_of_face());
    copy_array(p.group_radius, stored.group_radius());
    return p;
}

flatbuffers::Offset<file::Partition> pack(flatbuffers::FlatBufferBuilder& builder,
                                          const Partition& p)
{
    const auto* classes = reinterpret_cast<const std::uint8_t*>(p.edge_class.data());
    const auto map_of_face = builder.CreateVector(p.map_of_face);
    const auto edge_class = builder.CreateVector(classes, p.edge_class.size());
    const auto opposite = builder.CreateVector(p.opposite);
    const auto flipped = builder.CreateVector(p.flipped);
    const auto closed = builder.CreateVector(p.closed);
    const auto reach = builder.CreateVector(p.reach);
    const auto candidate = builder.CreateVector(p.candidate);
    const auto kept_edges = builder.CreateVector(p.kept_edges);
    const auto self_distance = builder.CreateVector(p.self_distance);
    const auto bridged = builder.CreateVector(p.bridged_edges);
    std::vector<MapId> maps;
    std::vector<float> points;
    for (const MapContact& contact : p.contacts) {
        maps.push_back(contact.map);
        for (const glm::vec3& end : {contact.a, contact.b})
            points.insert(points.end(), {end.x, end.y, end.z});
    }
    const auto contact_map = builder.CreateVector(maps);
    const auto contact_points = builder.CreateVector(points);
    const auto group_of_face = builder.CreateVector(p.group_of_face);
    const auto group_radius = builder.CreateVector(p.group_radius);
    return file::CreatePartition(builder, kVersion, partition_checksum(p), p.scene.words[0],
                                 p.scene.words[1], p.angle_threshold, p.map_count, map_of_face,
                                 edge_class, opposite, flipped, closed, reach, candidate,
                                 kept_edges, self_distance, p.position_error, bridged, contact_map,
                                 contact_points, p.group_count, group_of_face, group_radius);
}

InputError unreadable(const std::filesystem::path& path, const std::string& what)
{
    return InputError(path.string() + ": " + what + "; run preprocess again");
}

} // namespace

std::uint64_t partition_checksum(const Partition& p)
{
    const std::unique_ptr<XXH3_state_t, FreeState> state(XXH3_createState());
    if (!state || XXH3_64bits_reset(state.get()) == XXH_ERROR)
        throw std::bad_alloc();
    const auto add = [&](const auto& array) {
        const std::uint64_t size = array.size();
        XXH3_64bits_update(state.get(), &size, sizeof size);
        XXH3_64bits_update(state.get(), array.data(), size * sizeof array[0]);
    };
    add(p.scene.words);
    add(std::array{p.angle_threshold});
    add(std::array{p.map_count});
    add(p.map_of_face);
    add(p.edge_class);
    add(p.opposite);
    add(p.flipped);
    add(p.closed);
    add(p.reach);
    add(p.candidate);
    add(p.kept_edges);
    add(p.self_distance);
    add(std::array{p.position_error});
    add(p.bridged_edges);
    add(p.contacts);
    add(std::array{p.group_count});
    add(p.group_of_face);
    add(p.group_radius);
    return XXH3_64bits_digest(state.get());
}

void write_partition(const std::filesystem::path& path, const Partition& p)
{
    constexpr std::size_t kBytesPerFace = 3 * (sizeof(EdgeClass) + sizeof(std::uint32_t)) +
                                          sizeof(MapId) + sizeof(std::uint32_t) +
                                          3 * sizeof(float) + 4 * sizeof(std::uint8_t);
    constexpr std::size_t kBytesPerContact = sizeof(MapId) + 6 * sizeof(float);
    const std::size_t bytes = p.face_count() * kBytesPerFace +
                              p.contacts.size() * kBytesPerContact +
                              p.bridged_edges.size() * sizeof(std::uint32_t) + 1024;
    if (bytes > kMaxBytes)
        throw InputError(path.string() + ": a partition of " + std::to_string(p.face_count()) +
                         " faces does not fit the format (at most " +
                         std::to_string((kMaxBytes - 1024) / kBytesPerFace) +
                         "); split the scene or reduce it");

    flatbuffers::FlatBufferBuilder builder(bytes);
    const auto root = pack(builder, p);
    file::FinishPartitionBuffer(builder, root);
    write_file(path, std::as_bytes(std::span(builder.GetBufferPointer(), builder.GetSize())));
}

Partition read_partition(const std::filesystem::path& path)
{
    std::error_code unknown;
    if (const auto size = std::filesystem::file_size(path, unknown); !unknown && size > kMaxBytes)
        throw unreadable(path, "too large for a partition file");
    const std::vector<std::byte> bytes = read_file(path);
    const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.data());
    constexpr std::size_t kHeader = sizeof(flatbuffers::uoffset_t) + 4;
    if (bytes.size() < kHeader || std::memcmp(data + sizeof(flatbuffers::uoffset_t), "HPM", 3) != 0)
        throw unreadable(path, "not a partition file");
    if (!file::PartitionBufferHasIdentifier(data))
        throw unreadable(path, "written by another version of preprocess");
    flatbuffers::Verifier verifier(data, bytes.size());
    if (!file::VerifyPartitionBuffer(verifier))
        throw unreadable(path, "the partition file is truncated or damaged");
    const file::Partition& stored = *file::GetPartition(data);
    if (stored.version() != kVersion)
        throw unreadable(path, "written in version " + std::to_string(stored.version()) +
                                   " of the format, this program reads " +
                                   std::to_string(kVersion));
    Partition partition = unpack(stored);
    if (const std::string defect = defect_of(partition); !defect.empty())
        throw unreadable(path, "the partition file is damaged: " + defect);
    if (stored.checksum() != partition_checksum(partition))
        throw unreadable(path, "the partition file is damaged: its checksum is wrong");
    return partition;
}

void check_partition_of(const Partition& partition, const Scene& scene,
                        const std::filesystem::path& path)
{
    const std::size_t mine = partition.face_count();
    const std::size_t theirs = scene.mesh.face_count();
    if (mine == theirs && partition.scene == fingerprint(scene))
        return;
    const std::string faces =
        mine == theirs ? "the same number of faces, but different ones"
                       : std::to_string(mine) + " faces, the scene has " + std::to_string(theirs);
    throw InputError(path.string() + ": made for another scene (" + faces +
                     "); run preprocess on this scene again");
}

} // namespace hipmap
