#include "common/partition/expand_copies.h"

#include "common/input_error.h"

#include <algorithm>
#include <span>
#include <string>
#include <tuple>

namespace hipmap {

namespace {

/// Appends the values of faces that a copy has, each `per_face` of them and by a function of the
/// stored value.
template <typename T, typename Change>
void append(std::vector<T>& values, const SharedPart& part, std::size_t per_face,
            const Change& change)
{
    const std::size_t from = per_face * part.first_face;
    for (std::size_t i = 0; i < per_face * part.face_count; ++i)
        values.push_back(change(T(values[from + i])));
}

template <typename T>
T same(T value)
{
    return value;
}

/// The number `by` after an id.
auto later(std::uint32_t by)
{
    return [by](std::uint32_t id) { return id == kNone ? kNone : id + by; };
}

/// Appends contacts that a copy has as its shared faces do.
void append_contacts(Partition& out, std::span<const MapContact> stored, const SharedPart& part,
                     const Similarity& place, MapId first_map)
{
    const auto in_scene = [&](const glm::vec3& p) { return glm::vec3(place.point(glm::dvec3(p))); };
    for (const MapContact& contact : stored)
        if (contact.map - part.first_map < part.map_count)
            out.contacts.push_back({contact.map - part.first_map + first_map, in_scene(contact.a),
                                    in_scene(contact.b)});
}

/// The range of groups of a part, by number.
std::pair<std::uint32_t, std::uint32_t> groups_of(const Partition& p, const SharedPart& part)
{
    std::uint32_t low = kNone, high = 0;
    for (FaceId face = part.first_face; face < part.first_face + part.face_count; ++face)
        if (p.group_of_face[face] != kNone) {
            low = std::min(low, p.group_of_face[face]);
            high = std::max(high, p.group_of_face[face] + 1);
        }
    return low == kNone ? std::pair(0u, 0u) : std::pair(low, high);
}

void append_faces(Partition& out, const SharedPart& part, MapId first_map, double scale)
{
    const auto first_face = static_cast<FaceId>(out.face_count());
    const auto [group, groups_end] = groups_of(out, part);
    const auto scaled = [&](float length) { return static_cast<float>(length * scale); };
    append(out.edge_class, part, 3, same<EdgeClass>);
    append(out.opposite, part, 3, later(3 * (first_face - part.first_face)));
    append(out.flipped, part, 1, same<std::uint8_t>);
    append(out.closed, part, 1, same<std::uint8_t>);
    append(out.reach, part, 1, scaled);
    append(out.candidate, part, 1, same<std::uint8_t>);
    append(out.kept_edges, part, 1, same<std::uint8_t>);
    append(out.self_distance, part, 1, scaled);
    append(out.group_of_face, part, 1, later(out.group_count - group));
    append(out.group_radius, part, 1, scaled);
    append(out.map_of_face, part, 1, later(first_map - part.first_map));
    out.group_count += groups_end - group;
    const auto begin = std::ranges::lower_bound(out.bridged_edges, 3 * part.first_face);
    const auto end =
        std::ranges::lower_bound(out.bridged_edges, 3 * (part.first_face + part.face_count));
    const std::vector<std::uint32_t> bridged(begin, end);
    for (const std::uint32_t edge : bridged)
        out.bridged_edges.push_back(edge + 3 * (first_face - part.first_face));
}

} // namespace

Partition expand_copies(const Partition& partition, const TriangleMesh& mesh)
{
    if (partition.all_face_count() > kNone / 3)
        throw InputError("the scene has " + std::to_string(partition.all_face_count()) +
                         " faces with those of instances, too many to number their edges");
    Partition out = partition;
    for (std::uint32_t i = 0; i < partition.copies.size(); ++i) {
        const SharedPart& part = partition.shared[partition.copies[i]];
        const Similarity& place = mesh.copies[i].place;
        append_faces(out, part, partition.first_map_of_copy[i], place.scale);
        append_contacts(out, partition.contacts, part, place, partition.first_map_of_copy[i]);
    }
    out.map_count = partition.all_map_count();
    out.contacts.insert(out.contacts.end(), partition.own_contacts.begin(),
                        partition.own_contacts.end());
    std::ranges::stable_sort(out.contacts, {}, &MapContact::map);
    out.shared = {};
    out.copies = {};
    out.own_contacts = {};
    index_copies(out);
    return out;
}

} // namespace hipmap
