#include "preprocess/partition/summarise.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <functional>

namespace hipmap {
namespace {

/// How often stored faces stand in the scene.
class Times {
  public:
    explicit Times(const Partition& partition) : partition_(partition)
    {
        of_part_.assign(partition.shared.size(), 1);
        for (const std::uint32_t copy : partition.copies)
            ++of_part_[copy];
    }

    /// Returns the sum over faces of a number times how often the face stands in the scene.
    /// Parallel.
    template <typename NumberOf>
    std::size_t sum(const NumberOf& number_of) const
    {
        std::size_t out = 0;
        FaceId face = 0;
        const auto add = [&](FaceId end, std::size_t times) {
            out += times * tbb::parallel_reduce(
                               tbb::blocked_range<FaceId>(face, end), std::size_t{0},
                               [&](const auto& faces, std::size_t sum) {
                                   for (FaceId f = faces.begin(); f < faces.end(); ++f)
                                       sum += number_of(f);
                                   return sum;
                               },
                               std::plus());
            face = end;
        };
        for (std::size_t i = 0; i < of_part_.size(); ++i) {
            const SharedPart& part = partition_.shared[i];
            add(part.first_face, 1);
            add(part.first_face + part.face_count, of_part_[i]);
        }
        add(static_cast<FaceId>(partition_.face_count()), 1);
        return out;
    }

    /// part: kNone: of faces that are not shared.
    std::size_t of_part(std::uint32_t part) const { return part == kNone ? 1 : of_part_[part]; }

  private:
    const Partition& partition_;
    std::vector<std::size_t> of_part_;
};

void count_edges(PartitionSummary& summary, const Partition& partition, const Times& times)
{
    for (std::size_t kind = 0; kind < summary.edges.size(); ++kind)
        summary.edges[kind] += times.sum([&](FaceId face) {
            std::size_t count = 0;
            for (std::uint32_t edge = 3 * face; edge < 3 * face + 3; ++edge)
                count += partition.edge_class[edge] == static_cast<EdgeClass>(kind) &&
                         (partition.opposite[edge] == kNone || edge < partition.opposite[edge]);
            return count;
        });
    if (partition.copies.empty())
        summary.edges[static_cast<std::size_t>(EdgeClass::non_manifold)] =
            summary.defects.non_manifold_edges + summary.defects.cut_edges;
}

void add_map(PartitionSummary& summary, const PartitionSummary::Map& map)
{
    ++summary.map_count;
    summary.area += map.area;
    if (map.area > summary.largest.area)
        summary.largest = map;
}

void measure_maps(PartitionSummary& summary, const Partition& partition, const TriangleMesh& mesh)
{
    summary.maps.resize(partition.map_count);
    for (MapId id = 0; id < partition.map_count; ++id)
        summary.maps[id].id = id;
    // Areas are found in parallel and added in the order of faces: the same at any thread count.
    constexpr std::size_t kBlock = 1 << 16;
    std::vector<double> area(std::min(kBlock, mesh.face_count()));
    for (std::size_t begin = 0; begin < mesh.face_count(); begin += kBlock) {
        const std::size_t end = std::min(begin + kBlock, mesh.face_count());
        tbb::parallel_for(begin, end, [&](std::size_t face) {
            area[face - begin] = face_area(mesh, static_cast<FaceId>(face));
        });
        for (std::size_t face = begin; face < end; ++face) {
            if (partition.map_of_face[face] == kNone)
                continue;
            PartitionSummary::Map& map = summary.maps[partition.map_of_face[face]];
            ++map.faces;
            map.area += area[face - begin];
        }
    }
    for (const PartitionSummary::Map& map : summary.maps)
        add_map(summary, map);
    for_each_copied_map(summary, partition, mesh,
                        [&](const PartitionSummary::Map& map, MapId) { add_map(summary, map); });
}

} // namespace

void count_candidates(const Partition& partition, PartitionSummary& summary)
{
    const Times times(partition);
    summary.candidates = times.sum([&](FaceId face) { return partition.candidate[face]; });
    summary.groups = partition.group_count;
    summary.grouped_faces =
        times.sum([&](FaceId face) { return partition.group_of_face[face] != kNone; });
}

void summarise(const TriangleMesh& mesh, PartitionResult& result)
{
    const Partition& partition = result.partition;
    PartitionSummary& summary = result.summary;
    const Times times(partition);
    summary.faces = mesh.all_face_count();
    summary.contacts = partition.own_contacts.size();
    for (const MapContact& contact : partition.contacts)
        summary.contacts += times.of_part(part_of_map(partition, contact.map));
    summary.bridged_edges = partition.bridged_edges.empty() ? 0 : times.sum([&](FaceId face) {
        const auto first = std::ranges::lower_bound(partition.bridged_edges, 3 * face);
        return static_cast<std::size_t>(
            std::ranges::lower_bound(partition.bridged_edges, 3 * face + 3) - first);
    });
    count_candidates(partition, summary);
    summary.closed_faces = times.sum([&](FaceId face) { return partition.closed[face]; });
    count_edges(summary, partition, times);
    measure_maps(summary, partition, mesh);
}

} // namespace hipmap
