#include "preprocess/partition/previous_frame.h"

#include "preprocess/mesh/disjoint_sets.h"

#include <algorithm>
#include <cstring>
#include <iterator>

namespace hipmap {
namespace {

/// Whether two positions are the same to the bit: results may differ for 0 and -0.
bool same_bits(const glm::vec3& a, const glm::vec3& b)
{
    return std::memcmp(&a, &b, sizeof a) == 0;
}

/// The faces that hang together with what has moved, ascending.
std::vector<FaceId> faces_about_moved(const TriangleMesh& mesh, const VertexWeld& weld,
                                      const PreviousFrame& previous)
{
    DisjointSets sets(std::size_t{weld.count} +
                      previous.weld.count); // of vertices welded now, then
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        sets.unite(weld.id_of_vertex[v], weld.count + previous.weld.id_of_vertex[v]);
    for (const glm::uvec3& c : mesh.corners) {
        sets.unite(weld.id_of_vertex[c.x], weld.id_of_vertex[c.y]);
        sets.unite(weld.id_of_vertex[c.x], weld.id_of_vertex[c.z]);
    }
    std::vector<std::uint8_t> moved(std::size_t{weld.count} + previous.weld.count, 0); // by root
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        if (!same_bits(mesh.positions[v], previous.positions[v]))
            moved[sets.root(weld.id_of_vertex[v])] = 1;
    std::vector<FaceId> faces;
    for (FaceId face = 0; face < mesh.face_count(); ++face)
        if (moved[sets.root(weld.id_of_vertex[mesh.corners[face].x])] != 0)
            faces.push_back(face);
    return faces;
}

/// Some faces of a mesh, with all vertices, as far as half-edges go by them.
TriangleMesh part_of(const TriangleMesh& mesh, std::span<const FaceId> faces,
                     const std::vector<glm::vec3>& positions)
{
    TriangleMesh part;
    part.positions = positions;
    for (const FaceId face : faces) {
        part.corners.push_back(mesh.corners[face]);
        part.object_of_face.push_back(mesh.object_of_face[face]);
    }
    return part;
}

/// What find_half_edges found for the previous frame.
HalfEdges half_edges_of(const PreviousFrame& previous)
{
    const Partition& partition = previous.result.partition;
    HalfEdges out{partition.opposite, partition.edge_class, previous.flipped, partition.closed,
                  previous.result.summary.defects};
    std::ranges::replace(out.edge_class, EdgeClass::connected, EdgeClass::unconnected);
    return out;
}

/// Sets what is known of the faces of a part.
void put_part(const HalfEdges& part, std::span<const FaceId> faces, HalfEdges& out)
{
    for (std::uint32_t i = 0; i < faces.size(); ++i) {
        out.flipped[faces[i]] = part.flipped[i];
        out.closed[faces[i]] = part.closed[i];
        for (std::uint32_t c = 0; c < 3; ++c) {
            const std::uint32_t twin = part.opposite[3 * i + c];
            out.opposite[3 * faces[i] + c] = twin == kNone ? kNone : 3 * faces[twin / 3] + twin % 3;
            out.edge_class[3 * faces[i] + c] = part.edge_class[3 * i + c];
        }
    }
}

/// Counts of the whole, from which those of a part are taken away and added as they are now.
MeshDefects replace_part(const MeshDefects& whole, const MeshDefects& then, const MeshDefects& now)
{
    MeshDefects out;
    for (std::size_t MeshDefects::*count :
         {&MeshDefects::degenerate_faces, &MeshDefects::flipped_faces, &MeshDefects::border_edges,
          &MeshDefects::non_manifold_edges, &MeshDefects::cut_edges, &MeshDefects::refused_faces})
        out.*count = whole.*count - then.*count + now.*count;
    return out;
}

/// [F] 1: has moved, or has edges of another class or with another face beyond.
std::vector<std::uint8_t> changed_faces(const TriangleMesh& mesh, const Partition& now,
                                        const PreviousFrame& previous)
{
    const Partition& then = previous.result.partition;
    std::vector<std::uint8_t> changed(mesh.face_count(), 0);
    for (std::uint32_t edge = 0; edge < now.edge_class.size(); ++edge) {
        const std::uint32_t vertex = mesh.corners[edge / 3][static_cast<int>(edge % 3)];
        changed[edge / 3] |= !same_bits(mesh.positions[vertex], previous.positions[vertex]) ||
                             now.edge_class[edge] != then.edge_class[edge] ||
                             now.opposite[edge] != then.opposite[edge];
    }
    std::vector<std::uint32_t> edges;
    std::ranges::set_symmetric_difference(now.bridged_edges, then.bridged_edges,
                                          std::back_inserter(edges));
    for (const std::uint32_t edge : edges)
        changed[edge / 3] = 1;
    return changed;
}

} // namespace

HalfEdges find_half_edges(const TriangleMesh& mesh, const VertexWeld& weld,
                          const PreviousFrame& previous)
{
    const std::vector<FaceId> faces = faces_about_moved(mesh, weld, previous);
    if (2 * faces.size() > mesh.face_count()) // both parts would be more work than the whole
        return find_half_edges(mesh, weld);
    const HalfEdges then = find_half_edges(part_of(mesh, faces, previous.positions), previous.weld);
    const HalfEdges now = find_half_edges(part_of(mesh, faces, mesh.positions), weld);
    HalfEdges out = half_edges_of(previous);
    put_part(now, faces, out);
    out.defects = replace_part(out.defects, then.defects, now.defects);
    return out;
}

bool tree_serves(const TriangleMesh& mesh, std::span<const MapId> map_of_face,
                 const PreviousFrame& previous)
{
    constexpr std::size_t kFewerThan = 16; // one of so many may have moved
    std::size_t moved = 0;
    for (FaceId face = 0; face < mesh.face_count(); ++face) {
        const MapId then = previous.result.partition.map_of_face[face];
        if ((map_of_face[face] == kNone) != (then == kNone))
            return false;
        const std::uint32_t vertex = mesh.corners[face].x;
        moved += !same_bits(mesh.positions[vertex], previous.positions[vertex]);
    }
    return kFewerThan * moved <= mesh.face_count();
}

KnownMaps find_known_maps(const TriangleMesh& mesh, const Partition& now,
                          const PreviousFrame& previous)
{
    const Partition& then = previous.result.partition;
    KnownMaps out{std::vector<std::uint8_t>(now.map_count, 0),
                  std::vector<MapId>(then.map_count, kNone)};
    if (now.position_error != then.position_error) {
        std::ranges::fill(out.changed, 1);
        return out;
    }
    const std::vector<std::uint8_t> changed = changed_faces(mesh, now, previous);
    std::vector<MapId> then_of(now.map_count, kNone); // by the lowest face
    std::vector<std::uint8_t> parted(then.map_count, 0);
    for (FaceId face = 0; face < mesh.face_count(); ++face) {
        const MapId map = now.map_of_face[face], old = then.map_of_face[face];
        if (map != kNone && then_of[map] == kNone)
            then_of[map] = old;
        if (old != kNone && out.now[old] == kNone)
            out.now[old] = map;
        if (map != kNone)
            out.changed[map] |=
                changed[face] != 0 || then_of[map] != old || old == kNone || out.now[old] != map;
        if (old != kNone)
            parted[old] |= map == kNone || out.now[old] != map;
    }
    for (MapId old = 0; old < then.map_count; ++old)
        if (out.now[old] != kNone && parted[old] != 0)
            out.changed[out.now[old]] = 1;
    for (MapId& map : out.now)
        if (map != kNone && out.changed[map] != 0)
            map = kNone;
    return out;
}

void copy_known_self_distances(const PreviousFrame& previous, const KnownMaps& known,
                               std::span<const MapId> map_of_face, SelfDistances& out)
{
    const Partition& then = previous.result.partition;
    for (FaceId face = 0; face < map_of_face.size(); ++face)
        if (known.has(map_of_face[face])) {
            out.kept_edges[face] = then.kept_edges[face];
            out.self_distance[face] = then.self_distance[face];
        }
}

void copy_known_groups(const PreviousFrame& previous, const KnownMaps& known,
                       std::span<const MapId> map_of_face, GroupCandidates& out)
{
    const Partition& then = previous.result.partition;
    std::vector<FaceId> first(then.group_count, kNone); // of the faces of a group
    for (FaceId face = 0; face < map_of_face.size(); ++face) {
        const std::uint32_t group = then.group_of_face[face];
        if (group == kNone || !known.has(map_of_face[face]))
            continue;
        first[group] = std::min(first[group], face);
        out.group_of_face[face] = first[group];
        out.group_radius[face] = then.group_radius[face];
    }
}

void append_known_contacts(const PreviousFrame& previous, const KnownMaps& known,
                           std::vector<MadeContact>& out)
{
    for (MadeContact made : previous.contacts) {
        made.by = known.now[made.by];
        made.contact.map = known.now[made.contact.map];
        if (made.by != kNone && made.contact.map != kNone)
            out.push_back(made);
    }
}

} // namespace hipmap
