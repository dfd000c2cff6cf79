#include "preprocess/partition/copy_contacts.h"

#include "preprocess/partition/contact_face.h"
#include "preprocess/partition/contacts.h"
#include "preprocess/partition/copy_pairs.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

namespace hipmap {

namespace {

/// Errors within which faces meet, as for stored ones.
constexpr double kMeeting = 4;

/// Two faces of the scene, stored side by side as others want them.  For one thread.
class FacePair {
  public:
    FacePair(const TriangleMesh& mesh, const Partition& partition)
        : mesh_(mesh), partition_(partition)
    {
        pair_.positions.resize(6);
        pair_.corners = {{0, 1, 2}, {3, 4, 5}};
    }

    /// Takes two faces, the lower one first; returns whether their planes let them meet.
    bool take(FaceId f, FaceId g)
    {
        faces_ = {std::min(f, g), std::max(f, g)};
        for (std::size_t i = 0; i < 2; ++i)
            std::ranges::copy(mesh_.triangle(faces_[i]), pair_.positions.begin() + 3 * i);
        return reaches(0) && reaches(1);
    }

    /// Whether two corners of one coincide with two of the other.
    bool share_edge() const
    {
        int count = 0;
        for (int i = 0; i < 3; ++i)
            for (int j = 3; j < 6; ++j)
                count += pair_.positions[i] == pair_.positions[j];
        return count > 1;
    }

    /// Whether an edge of one beyond which a surface may go on lies on the other, in its plane.
    bool may_be_seam() const
    {
        const ContactFace f(pair_, 0, error()), g(pair_, 1, error());
        if (f.too_thin() || g.too_thin() || !parallel(f, g) || !(glm::dot(f.normal, g.normal) > 0))
            return false;
        return ends_on(faces_[0], f, g) || ends_on(faces_[1], g, f);
    }

    void append_contacts(std::vector<MapContact>& out)
    {
        bridged_.clear();
        for (std::uint32_t i = 0; i < 2; ++i) {
            const FaceId stored = mesh_.stored_face(faces_[i]);
            for (std::uint32_t c = 0; c < 3; ++c) {
                classes_[3 * i + c] = partition_.edge_class[3 * stored + c];
                if (std::ranges::binary_search(partition_.bridged_edges, 3 * stored + c))
                    bridged_.push_back(3 * i + c);
            }
            maps_[i] = partition_.map_of(faces_[i]);
        }
        hipmap::append_contacts({pair_, classes_, kNoOpposites, maps_, bridged_, error()}, 0, 1,
                                out);
    }

  private:
    static constexpr std::array<std::uint32_t, 6> kNoOpposites{kNone, kNone, kNone,
                                                               kNone, kNone, kNone};

    double error() const { return partition_.position_error; }

    /// Whether the other face has no side of the plane of face i to itself.
    bool reaches(FaceId i) const
    {
        const glm::dvec3 normal = scaled_normal(pair_, i);
        const double margin = kMeeting * error() * glm::length(normal);
        double low = INFINITY, high = -INFINITY;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const double height =
                glm::dot(normal, glm::dvec3(pair_.positions[3 * (1 - i) + corner]) -
                                     glm::dvec3(pair_.positions[3 * i]));
            low = std::min(low, height);
            high = std::max(high, height);
        }
        return low <= margin && high >= -margin;
    }

    bool ends_on(FaceId face, const ContactFace& own, const ContactFace& other) const
    {
        for (std::uint32_t c = 0; c < 3; ++c)
            if (may_go_on(3 * mesh_.stored_face(face) + c) &&
                other.part_on(own.corners[c], own.corners[(c + 1) % 3]))
                return true;
        return false;
    }

    /// As for stored faces, or the neighbour is none that all copies have.
    bool may_go_on(std::uint32_t edge) const
    {
        const std::uint32_t twin = partition_.opposite[edge];
        if (twin == kNone)
            return true;
        if (partition_.edge_class[edge] == EdgeClass::unconnected &&
            partition_.flipped[edge / 3] != partition_.flipped[twin / 3])
            return true;
        return shared_with(edge / 3) != shared_with(twin / 3);
    }

    /// The shared faces that a stored face is among; null: it is not shared.
    const SharedFaces* shared_with(FaceId face) const
    {
        const auto next = std::ranges::upper_bound(mesh_.shared, face, {}, &SharedFaces::first);
        return next != mesh_.shared.begin() && face - (next - 1)->first < (next - 1)->count
                   ? &*(next - 1)
                   : nullptr;
    }

    const TriangleMesh& mesh_;
    const Partition& partition_;
    TriangleMesh pair_;
    std::array<FaceId, 2> faces_{};
    std::array<EdgeClass, 6> classes_{};
    std::array<MapId, 2> maps_{};
    std::vector<std::uint32_t> bridged_;
};

/// Sorts contacts by map into those of maps that only stored faces have and the others.
void deal_out(const std::vector<MapContact>& contacts, Partition& partition)
{
    for (const MapContact& contact : contacts) {
        const bool shared =
            contact.map >= partition.map_count || part_of_map(partition, contact.map) != kNone;
        (shared ? partition.own_contacts : partition.contacts).push_back(contact);
    }
    sort_contacts(partition.own_contacts);
    sort_contacts(partition.contacts);
}

} // namespace

std::vector<SharedPart> find_shared_parts(const TriangleMesh& mesh, const Partition& partition)
{
    std::vector<SharedPart> out;
    std::vector<std::uint32_t> part_of_map(partition.map_count, kNone);
    for (const SharedFaces& faces : mesh.shared) {
        SharedPart part{faces.first, faces.count, kNone, 0};
        MapId end = 0;
        for (FaceId face = faces.first; face < faces.first + faces.count; ++face) {
            for (std::size_t c = 0; c < 3; ++c)
                if (const std::uint32_t twin = partition.opposite[std::size_t{3} * face + c];
                    twin != kNone && twin / 3 - faces.first >= faces.count)
                    return {};
            if (const MapId map = partition.map_of_face[face]; map != kNone) {
                part.first_map = std::min(part.first_map, map);
                end = std::max(end, map + 1);
                part_of_map[map] = static_cast<std::uint32_t>(out.size());
            }
        }
        part.first_map = std::min(part.first_map, end);
        part.map_count = end - part.first_map;
        out.push_back(part);
    }
    for (FaceId face = 0; face < partition.face_count(); ++face) {
        const MapId map = partition.map_of_face[face];
        const std::uint32_t part = map == kNone ? kNone : part_of_map[map];
        if (part != kNone && face - out[part].first_face >= out[part].face_count)
            return {};
    }
    return out;
}

std::vector<std::uint32_t> find_joined_places(const TriangleMesh& mesh, const Partition& partition)
{
    const CopyPairs pairs(mesh, partition.map_of_face, kMeeting * partition.position_error);
    std::vector<std::uint8_t> joined(pairs.place_count(), 0);
    tbb::enumerable_thread_specific<FacePair> scratch([&] { return FacePair(mesh, partition); });
    tbb::parallel_for(std::uint32_t{0}, pairs.place_count(), [&](std::uint32_t place) {
        FacePair& pair = scratch.local();
        pairs.visit(
            place, [](std::uint32_t) { return true; },
            [&](FaceId face, FaceId other) {
                if (pair.take(face, other) && (pair.share_edge() || pair.may_be_seam()))
                    joined[place] = 1;
                return joined[place] == 0;
            });
    });
    std::vector<std::uint32_t> out;
    for (std::uint32_t place = 0; place < joined.size(); ++place)
        if (joined[place] != 0)
            out.push_back(place);
    return out;
}

void add_copy_contacts(const TriangleMesh& mesh, Partition& partition)
{
    const CopyPairs pairs(mesh, partition.map_of_face, kMeeting * partition.position_error);
    struct Scratch {
        FacePair pair;
        std::vector<MapContact> found;
    };
    tbb::enumerable_thread_specific<Scratch> scratch([&] {
        return Scratch{FacePair(mesh, partition), {}};
    });
    const auto stored = static_cast<std::uint32_t>(mesh.shared.size());
    tbb::parallel_for(stored, pairs.place_count(), [&](std::uint32_t place) {
        Scratch& mine = scratch.local();
        // A pair of copies is looked at from the later one.
        pairs.visit(
            place, [&](std::uint32_t other) { return other < place; },
            [&](FaceId face, FaceId other) {
                if (mine.pair.take(face, other))
                    mine.pair.append_contacts(mine.found);
                return true;
            });
    });
    std::vector<MapContact> found;
    for (const Scratch& some : scratch)
        found.insert(found.end(), some.found.begin(), some.found.end());
    deal_out(found, partition);
}

} // namespace hipmap
