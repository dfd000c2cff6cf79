#include "common/partition/partition_file.h"

#include "common/file/output_file.h"
#include "common/input_error.h"
#include "common/partition/check_partition.h"
#include "common/partition/partition_generated.h"
#include "common/scene/store_copies.h"

#include <flatbuffers/flatbuffers.h>
#include <tbb/parallel_pipeline.h>
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <new>
#include <span>
#include <string>

namespace hipmap {
namespace {

constexpr std::uint32_t kVersion = 5;

/// A longer chunk is refused.  FlatBuffers offsets are 31 bits, and its Release builder writes past
/// them without a word.
constexpr std::size_t kLongestChunk = std::size_t{1} << 30;

/// Bytes that all arrays of a file take for each face.
constexpr std::size_t kBytesPerFace = 3 * (sizeof(EdgeClass) + sizeof(std::uint32_t)) +
                                      sizeof(MapId) + sizeof(std::uint32_t) + 3 * sizeof(float) +
                                      4 * sizeof(std::uint8_t);

/// What a chunk has beside its arrays, at most.
constexpr std::size_t kChunkOverhead = 1024;

/// Chunks that are packed while others are written.
constexpr std::size_t kChunksAtOnce = 3;

std::size_t bytes_of_arrays(const Partition& p)
{
    constexpr std::size_t kBytesPerContact = sizeof(MapId) + 6 * sizeof(float);
    return p.face_count() * kBytesPerFace +
           (p.contacts.size() + p.own_contacts.size()) * kBytesPerContact +
           (p.apart.size() + p.copies.size() + p.bridged_edges.size()) * sizeof(std::uint32_t);
}

struct FreeState {
    void operator()(XXH3_state_t* state) const { XXH3_freeState(state); }
};

/// Appends one array of a chunk; an absent one is empty.
template <typename T, typename Stored>
void append_array(std::vector<T>& to, const flatbuffers::Vector<Stored>* from)
{
    static_assert(sizeof(T) == sizeof(Stored));
    if (!from || from->size() == 0)
        return;
    const std::size_t before = to.size();
    to.resize(before + from->size());
    std::memcpy(to.data() + before, from->data(), from->size() * sizeof(T));
}

/// Contacts lie in two arrays of the file; arrays that do not fit each other give none.
void append_contacts(std::vector<MapContact>& contacts,
                     const flatbuffers::Vector<std::uint32_t>* stored_maps,
                     const flatbuffers::Vector<float>* stored_points)
{
    std::vector<MapId> maps;
    std::vector<float> points;
    append_array(maps, stored_maps);
    append_array(points, stored_points);
    if (points.size() != 6 * maps.size())
        return;
    for (std::size_t i = 0; i < maps.size(); ++i) {
        const float* p = &points[6 * i];
        contacts.push_back({maps[i], {p[0], p[1], p[2]}, {p[3], p[4], p[5]}});
    }
}

/// Parts lie in one array of the file, which is not cut within one.
void append_shared(std::vector<SharedPart>& shared, const file::Partition& stored)
{
    std::vector<std::uint32_t> numbers;
    append_array(numbers, stored.shared());
    for (std::size_t i = 0; i + 4 <= numbers.size(); i += 4)
        shared.push_back({numbers[i], numbers[i + 1], numbers[i + 2], numbers[i + 3]});
}

/// Appends the arrays of a chunk, and takes the rest from it.
void append_chunk(Partition& p, const file::Partition& stored)
{
    p.scene.words = {stored.scene_0(), stored.scene_1()};
    p.angle_threshold = stored.angle_threshold();
    p.map_count = stored.map_count();
    append_array(p.map_of_face, stored.map_of_face());
    append_array(p.edge_class, stored.edge_class());
    append_array(p.opposite, stored.opposite());
    append_array(p.flipped, stored.flipped());
    append_array(p.closed, stored.closed());
    append_array(p.reach, stored.reach());
    append_array(p.candidate, stored.candidate());
    append_array(p.kept_edges, stored.kept_edges());
    append_array(p.self_distance, stored.clearance());
    p.position_error = stored.position_error();
    append_array(p.bridged_edges, stored.bridged_edges());
    append_contacts(p.contacts, stored.contact_map(), stored.contact_points());
    p.group_count = stored.group_count();
    append_array(p.group_of_face, stored.group_of_face());
    append_array(p.group_radius, stored.group_radius());
    append_array(p.apart, stored.apart());
    append_shared(p.shared, stored);
    append_array(p.copies, stored.copies());
    append_contacts(p.own_contacts, stored.own_contact_map(), stored.own_contact_points());
}

/// Makes room for the arrays of a file, so that they do not grow chunk by chunk.
void reserve(Partition& p, std::size_t faces)
{
    const auto reserve_all = [faces](auto&... arrays) { (arrays.reserve(faces), ...); };
    reserve_all(p.map_of_face, p.flipped, p.closed, p.reach, p.candidate, p.kept_edges,
                p.self_distance, p.group_of_face, p.group_radius);
    p.edge_class.reserve(3 * faces);
    p.opposite.reserve(3 * faces);
}

/// One of `count` chunks: it holds as large a part of every array.
struct ChunkPlace {
    std::size_t index = 0, count = 1;

    template <typename T>
    std::span<const T> of(const std::vector<T>& all) const
    {
        const std::size_t begin = all.size() * index / count;
        return std::span(all).subspan(begin, all.size() * (index + 1) / count - begin);
    }
};

/// The contacts of a chunk as the file has them.
struct StoredContacts {
    flatbuffers::Offset<flatbuffers::Vector<std::uint32_t>> maps;
    flatbuffers::Offset<flatbuffers::Vector<float>> points;
};

StoredContacts pack_contacts(flatbuffers::FlatBufferBuilder& builder,
                             std::span<const MapContact> contacts)
{
    std::vector<MapId> maps;
    std::vector<float> points;
    for (const MapContact& contact : contacts) {
        maps.push_back(contact.map);
        for (const glm::vec3& end : {contact.a, contact.b})
            points.insert(points.end(), {end.x, end.y, end.z});
    }
    return {builder.CreateVector(maps), builder.CreateVector(points)};
}

flatbuffers::Offset<flatbuffers::Vector<std::uint32_t>>
pack_shared(flatbuffers::FlatBufferBuilder& builder, std::span<const SharedPart> shared)
{
    std::vector<std::uint32_t> numbers;
    for (const SharedPart& part : shared)
        numbers.insert(numbers.end(),
                       {part.first_face, part.face_count, part.first_map, part.map_count});
    return builder.CreateVector(numbers);
}

flatbuffers::Offset<file::Partition> pack(flatbuffers::FlatBufferBuilder& builder,
                                          const Partition& p, std::uint64_t checksum,
                                          const ChunkPlace& place)
{
    const auto stored = [&](const auto& all) {
        const auto part = place.of(all);
        return builder.CreateVector(part.data(), part.size());
    };
    const std::span<const EdgeClass> classes = place.of(p.edge_class);
    const auto map_of_face = stored(p.map_of_face);
    const auto edge_class =
        builder.CreateVector(reinterpret_cast<const std::uint8_t*>(classes.data()), classes.size());
    const auto opposite = stored(p.opposite);
    const auto flipped = stored(p.flipped);
    const auto closed = stored(p.closed);
    const auto reach = stored(p.reach);
    const auto candidate = stored(p.candidate);
    const auto kept_edges = stored(p.kept_edges);
    const auto self_distance = stored(p.self_distance);
    const auto bridged = stored(p.bridged_edges);
    const StoredContacts contacts = pack_contacts(builder, place.of(p.contacts));
    const auto group_of_face = stored(p.group_of_face);
    const auto group_radius = stored(p.group_radius);
    const auto apart = stored(p.apart);
    const auto shared = pack_shared(builder, place.of(p.shared));
    const auto copies = stored(p.copies);
    const StoredContacts own = pack_contacts(builder, place.of(p.own_contacts));
    return file::CreatePartition(
        builder, kVersion, checksum, p.scene.words[0], p.scene.words[1], p.angle_threshold,
        p.map_count, map_of_face, edge_class, opposite, flipped, closed, reach, candidate,
        kept_edges, self_distance, p.position_error, bridged, contacts.maps, contacts.points,
        p.group_count, group_of_face, group_radius, static_cast<std::uint32_t>(place.count), apart,
        shared, copies, own.maps, own.points);
}

InputError unreadable(const std::filesystem::path& path, const std::string& what)
{
    return InputError(path.string() + ": " + what + "; run preprocess again");
}

/// Reads and verifies the next chunk of a file, into `bytes`, and returns it.
const file::Partition& read_chunk(InputFile& file, const std::filesystem::path& path,
                                  std::vector<std::byte>& bytes)
{
    constexpr std::size_t kPrefix = sizeof(flatbuffers::uoffset_t);
    constexpr std::size_t kHeader = 2 * kPrefix + 4; // the length, the root and the identifier
    bytes.clear();
    file.append(bytes, std::min(file.left(), kHeader));
    const auto says_hpm = [&](std::size_t at) {
        return bytes.size() >= at + 4 && std::memcmp(bytes.data() + at, "HPM", 3) == 0;
    };
    if (says_hpm(kPrefix)) // up to version 3 there was no length
        throw unreadable(path, "written by another version of preprocess");
    if (!says_hpm(2 * kPrefix))
        throw unreadable(path, "not a partition file");
    if (!flatbuffers::BufferHasIdentifier(bytes.data(), file::PartitionIdentifier(), true))
        throw unreadable(path, "written by another version of preprocess");
    const char* const damaged = "the partition file is truncated or damaged";
    const std::size_t rest =
        flatbuffers::GetPrefixedSize(reinterpret_cast<const std::uint8_t*>(bytes.data())) +
        kPrefix - bytes.size();
    if (rest > kLongestChunk || rest > file.left())
        throw unreadable(path, damaged);
    file.append(bytes, rest);
    const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.data());
    flatbuffers::Verifier verifier(data, bytes.size());
    if (!file::VerifySizePrefixedPartitionBuffer(verifier))
        throw unreadable(path, damaged);
    const file::Partition& stored = *file::GetSizePrefixedPartition(data);
    if (stored.version() != kVersion)
        throw unreadable(path, "written in version " + std::to_string(stored.version()) +
                                   " of the format, this program reads " +
                                   std::to_string(kVersion));
    return stored;
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
    if (!p.apart.empty() || !p.copies.empty()) {
        add(p.apart);
        add(p.shared);
        add(p.copies);
        add(p.own_contacts);
    }
    return XXH3_64bits_digest(state.get());
}

void write_partition(const std::filesystem::path& path, const Partition& p, std::size_t chunk_bytes)
{
    const std::size_t bytes = bytes_of_arrays(p);
    const std::size_t count = bytes / chunk_bytes + 1;
    const std::uint64_t checksum = partition_checksum(p);
    std::vector<flatbuffers::FlatBufferBuilder> builders;
    for (std::size_t i = 0; i < std::min(count, kChunksAtOnce); ++i)
        builders.emplace_back(bytes / count + kChunkOverhead);
    // Chunks leave in order, so the one that had a builder before has left.
    const auto pack_chunk = [&](std::size_t i) {
        flatbuffers::FlatBufferBuilder& builder = builders[i % kChunksAtOnce];
        builder.Clear();
        file::FinishSizePrefixedPartitionBuffer(builder, pack(builder, p, checksum, {i, count}));
        return i;
    };
    WholeFile file(path);
    const auto write_chunk = [&](std::size_t i) {
        const flatbuffers::FlatBufferBuilder& builder = builders[i % kChunksAtOnce];
        file.write(std::as_bytes(std::span(builder.GetBufferPointer(), builder.GetSize())));
    };
    std::size_t next = 0;
    const auto next_chunk = [&](tbb::flow_control& flow) {
        if (next == count)
            flow.stop();
        return next++;
    };
    constexpr auto kInOrder = tbb::filter_mode::serial_in_order;
    tbb::parallel_pipeline(
        kChunksAtOnce,
        tbb::make_filter<void, std::size_t>(kInOrder, next_chunk) &
            tbb::make_filter<std::size_t, std::size_t>(tbb::filter_mode::parallel, pack_chunk) &
            tbb::make_filter<std::size_t, void>(kInOrder, write_chunk));
    file.commit();
}

Partition read_partition(const std::filesystem::path& path)
{
    InputFile file(path);
    Partition partition;
    reserve(partition, file.left() / kBytesPerFace);
    std::uint64_t checksum = 0;
    std::uint32_t chunks = 0, read = 0;
    std::vector<std::byte> bytes;
    do {
        const file::Partition& stored = read_chunk(file, path, bytes);
        append_chunk(partition, stored);
        if (read++ == 0) {
            checksum = stored.checksum();
            chunks = stored.chunk_count();
        }
    } while (file.left() > 0);
    if (read != chunks)
        throw unreadable(path, "the partition file is truncated or damaged");
    if (const std::string defect = defect_of(partition); !defect.empty())
        throw unreadable(path, "the partition file is damaged: " + defect);
    index_copies(partition);
    if (checksum != partition_checksum(partition))
        throw unreadable(path, "the partition file is damaged: its checksum is wrong");
    return partition;
}

void check_partition_of(const Partition& partition, const Scene& scene,
                        const std::filesystem::path& path)
{
    const std::size_t mine = partition.all_face_count();
    const std::size_t theirs = scene.mesh.all_face_count();
    if (mine == theirs && partition.scene == fingerprint(scene))
        return;
    const std::string faces =
        mine == theirs ? "the same number of faces, but different ones"
                       : std::to_string(mine) + " faces, the scene has " + std::to_string(theirs);
    throw InputError(path.string() + ": made for another scene (" + faces +
                     "); run preprocess on this scene again");
}

void set_apart_for(const Partition& partition, TriangleMesh& mesh,
                   const std::filesystem::path& path)
{
    const std::size_t places = mesh.shared.size() + mesh.copies.size();
    bool fits = partition.apart.empty() || partition.apart.back() < places;
    if (fits)
        set_apart(mesh, partition.apart);
    fits = fits && partition.face_count() == mesh.face_count() &&
           partition.shared.size() == mesh.shared.size() &&
           partition.copies.size() == mesh.copies.size();
    for (std::size_t i = 0; fits && i < mesh.shared.size(); ++i)
        fits = partition.shared[i].first_face == mesh.shared[i].first &&
               partition.shared[i].face_count == mesh.shared[i].count;
    for (std::size_t i = 0; fits && i < mesh.copies.size(); ++i)
        fits = partition.copies[i] == mesh.copies[i].shared;
    if (!fits)
        throw InputError(path.string() + ": made for another scene (its instances are others); "
                                         "run preprocess on this scene again");
}

} // namespace hipmap
