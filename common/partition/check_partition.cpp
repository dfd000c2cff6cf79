#include "common/partition/check_partition.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hipmap {
namespace {

bool all_flags(const std::vector<std::uint8_t>& flags)
{
    return std::ranges::all_of(flags, [](std::uint8_t flag) { return flag <= 1; });
}

std::string defect_of_sizes(const Partition& p)
{
    const std::size_t faces = p.face_count();
    if (faces > kNone / 3)
        return "too many faces";
    if (p.edge_class.size() != 3 * faces || p.opposite.size() != 3 * faces ||
        p.flipped.size() != faces || p.closed.size() != faces || p.reach.size() != faces ||
        p.candidate.size() != faces || p.kept_edges.size() != faces ||
        p.self_distance.size() != faces || p.group_of_face.size() != faces ||
        p.group_radius.size() != faces)
        return "its arrays differ in length";
    return {};
}

std::string defect_of_faces(const Partition& p)
{
    MapId next = 0;
    for (FaceId face = 0; face < p.face_count(); ++face) {
        const MapId map = p.map_of_face[face];
        const auto place = [&] { return "face " + std::to_string(face); };
        if (map != kNone && map > next)
            return place() + " has a map id out of order";
        if (map == next)
            ++next;
        if (!(p.reach[face] >= 0))
            return place() + " has no valid reach";
        if (!(p.self_distance[face] >= 0) || p.kept_edges[face] > 7)
            return place() + " has no valid self-distance";
        if (map == kNone && p.candidate[face])
            return place() + " has no map but asks for a local one";
    }
    return next == p.map_count ? "" : "the number of its maps is wrong";
}

std::string defect_of_groups(const Partition& p)
{
    std::vector<MapId> map_of_group;
    for (FaceId face = 0; face < p.face_count(); ++face) {
        const std::uint32_t group = p.group_of_face[face];
        const MapId map = p.map_of_face[face];
        const auto place = [&] { return "face " + std::to_string(face); };
        if (!(p.group_radius[face] >= 0 && std::isfinite(p.group_radius[face])))
            return place() + " has no valid group radius";
        if (group == kNone) {
            if (p.group_radius[face] > 0)
                return place() + " has a group radius but no group";
            continue;
        }
        if (group > map_of_group.size())
            return place() + " has a group id out of order";
        if (group == map_of_group.size())
            map_of_group.push_back(map);
        if (map == kNone || map != map_of_group[group])
            return place() + " is of a group in another map";
    }
    return map_of_group.size() == p.group_count ? "" : "the number of its groups is wrong";
}

std::string defect_of_edge(const Partition& p, std::uint32_t edge)
{
    const std::uint32_t twin = p.opposite[edge];
    const EdgeClass edge_class = p.edge_class[edge];
    const MapId map = p.map_of_face[edge / 3];
    if (edge_class > EdgeClass::degenerate)
        return "is of no known class";
    if ((edge_class == EdgeClass::degenerate) != (map == kNone))
        return "does not agree with its face";
    const bool has_twin =
        edge_class == EdgeClass::connected || edge_class == EdgeClass::unconnected;
    if (has_twin != (twin != kNone))
        return "does not agree with its opposite";
    if (!has_twin)
        return {};
    if (twin >= p.opposite.size() || twin / 3 == edge / 3 || p.opposite[twin] != edge ||
        p.edge_class[twin] != edge_class)
        return "does not agree with its opposite";
    if (edge_class == EdgeClass::connected && p.map_of_face[twin / 3] != map)
        return "connects two maps";
    return {};
}

bool finite(const glm::vec3& v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

std::string defect_of_contacts(const std::vector<MapContact>& contacts, std::uint64_t map_count)
{
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const MapContact& contact = contacts[i];
        if (contact.map >= map_count || (i > 0 && contact.map < contacts[i - 1].map) ||
            !finite(contact.a) || !finite(contact.b))
            return "contact " + std::to_string(i) + " is not valid";
    }
    return {};
}

/// Of the faces of a part: they have the part's maps and no neighbours outside.
std::string defect_of_part(const Partition& p, const SharedPart& part)
{
    for (FaceId face = part.first_face; face < part.first_face + part.face_count; ++face) {
        const MapId map = p.map_of_face[face];
        if (map != kNone && map - part.first_map >= part.map_count)
            return "face " + std::to_string(face) + " has a map outside of its shared faces";
        for (std::size_t c = 0; c < 3; ++c)
            if (const std::uint32_t twin = p.opposite[std::size_t{3} * face + c];
                twin != kNone && twin / 3 - part.first_face >= part.face_count)
                return "face " + std::to_string(face) +
                       " has a neighbour outside of its shared faces";
    }
    return {};
}

std::string defect_of_copies(const Partition& p)
{
    std::uint64_t next_face = 0;
    for (const SharedPart& part : p.shared) {
        if (part.first_face < next_face || part.face_count == 0 ||
            std::uint64_t{part.first_face} + part.face_count > p.face_count() ||
            std::uint64_t{part.first_map} + part.map_count > p.map_count)
            return "its shared faces are not valid";
        next_face = std::uint64_t{part.first_face} + part.face_count;
        if (std::string defect = defect_of_part(p, part); !defect.empty())
            return defect;
    }
    std::uint64_t faces = p.face_count(), maps = p.map_count;
    for (const std::uint32_t copy : p.copies) {
        if (copy >= p.shared.size())
            return "a copy is of no shared faces";
        faces += p.shared[copy].face_count;
        maps += p.shared[copy].map_count;
    }
    if (faces >= kNone || maps >= kNone)
        return "too many faces or maps with those of copies";
    if (!std::ranges::is_sorted(p.apart))
        return "its places set apart are out of order";
    return defect_of_contacts(p.own_contacts, maps);
}

std::string defect_of_boundaries(const Partition& p)
{
    for (std::size_t i = 0; i < p.bridged_edges.size(); ++i) {
        const std::uint32_t edge = p.bridged_edges[i];
        if (edge >= p.edge_class.size() || (i > 0 && edge <= p.bridged_edges[i - 1]) ||
            (p.edge_class[edge] != EdgeClass::border &&
             p.edge_class[edge] != EdgeClass::non_manifold))
            return "bridged edge " + std::to_string(i) + " is not valid";
    }
    return defect_of_contacts(p.contacts, p.map_count);
}

} // namespace

std::string defect_of(const Partition& p)
{
    if (std::string defect = defect_of_sizes(p); !defect.empty())
        return defect;
    if (!(p.angle_threshold >= 0 && p.angle_threshold <= std::numbers::pi))
        return "its angle threshold is out of range";
    if (!(p.position_error >= 0 && std::isfinite(p.position_error)))
        return "its position error is out of range";
    if (!all_flags(p.flipped) || !all_flags(p.closed) || !all_flags(p.candidate))
        return "a flag is neither 0 nor 1";
    if (std::string defect = defect_of_faces(p); !defect.empty())
        return defect;
    if (std::string defect = defect_of_groups(p); !defect.empty())
        return defect;
    if (std::string defect = defect_of_boundaries(p); !defect.empty())
        return defect;
    if (std::string defect = defect_of_copies(p); !defect.empty())
        return defect;
    for (std::uint32_t edge = 0; edge < p.edge_class.size(); ++edge)
        if (const std::string defect = defect_of_edge(p, edge); !defect.empty())
            return "edge " + std::to_string(edge) + " " + defect;
    return {};
}

} // namespace hipmap
