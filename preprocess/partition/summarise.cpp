#include "preprocess/partition/summarise.h"

#include <algorithm>

namespace hipmap {
namespace {

void count_edges(PartitionSummary& summary, const Partition& partition)
{
    for (std::uint32_t edge = 0; edge < partition.edge_class.size(); ++edge)
        if (partition.opposite[edge] == kNone || edge < partition.opposite[edge])
            ++summary.edges[static_cast<std::size_t>(partition.edge_class[edge])];
    summary.edges[static_cast<std::size_t>(EdgeClass::non_manifold)] =
        summary.defects.non_manifold_edges + summary.defects.cut_edges;
}

void measure_maps(PartitionSummary& summary, const Partition& partition, const TriangleMesh& mesh)
{
    summary.maps.resize(partition.map_count);
    for (MapId id = 0; id < partition.map_count; ++id)
        summary.maps[id].id = id;
    for (FaceId face = 0; face < mesh.face_count(); ++face) {
        if (partition.map_of_face[face] == kNone)
            continue;
        PartitionSummary::Map& map = summary.maps[partition.map_of_face[face]];
        ++map.faces;
        map.area += face_area(mesh, face);
    }
}

} // namespace

void summarise(const TriangleMesh& mesh, PartitionResult& result)
{
    const Partition& partition = result.partition;
    PartitionSummary& summary = result.summary;
    summary.faces = mesh.face_count();
    summary.contacts = partition.contacts.size();
    summary.bridged_edges = partition.bridged_edges.size();
    summary.candidates = static_cast<std::size_t>(std::ranges::count(partition.candidate, 1));
    summary.groups = partition.group_count;
    summary.grouped_faces =
        mesh.face_count() -
        static_cast<std::size_t>(std::ranges::count(partition.group_of_face, kNone));
    summary.closed_faces = static_cast<std::size_t>(std::ranges::count(partition.closed, 1));
    count_edges(summary, partition);
    measure_maps(summary, partition, mesh);
}

} // namespace hipmap
