#include "common/partition/partition.h"

#include <algorithm>

namespace hipmap {

std::uint32_t part_of_map(const Partition& partition, MapId map)
{
    const auto next = std::ranges::upper_bound(partition.shared, map, {}, &SharedPart::first_map);
    if (next == partition.shared.begin())
        return kNone;
    const auto part = next - 1;
    return map - part->first_map < part->map_count
               ? static_cast<std::uint32_t>(part - partition.shared.begin())
               : kNone;
}

void index_copies(Partition& partition)
{
    std::vector<FaceId> first;
    partition.first_map_of_copy.clear();
    auto face = static_cast<FaceId>(partition.face_count());
    MapId map = partition.map_count;
    for (const std::uint32_t copy : partition.copies) {
        first.push_back(face);
        partition.first_map_of_copy.push_back(map);
        face += partition.shared[copy].face_count;
        map += partition.shared[copy].map_count;
    }
    partition.finder = CopyFinder(std::move(first), face);
}

} // namespace hipmap
