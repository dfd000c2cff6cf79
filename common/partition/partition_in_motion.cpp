#include "common/partition/partition_in_motion.h"

#include "common/math/bounds.h"

#include <algorithm>
#include <map>

namespace hipmap {

namespace {

using Box = Bounds<glm::vec3>;

bool has_moved(const TriangleMesh& then, const TriangleMesh& now, FaceId face)
{
    for (int c = 0; c < 3; ++c)
        if (then.positions[then.corners[face][c]] != now.positions[now.corners[face][c]])
            return true;
    return false;
}

/// What has moved, as it was.
struct Moved {
    std::vector<std::uint8_t> maps; ///< [map_count] 1: some face of it has
    std::map<ObjectId, Box> boxes;  ///< of the faces that have, by object
};

Moved find_moved(const Partition& partition, const TriangleMesh& then, const TriangleMesh& now)
{
    Moved out{std::vector<std::uint8_t>(partition.map_count, 0), {}};
    for (FaceId face = 0; face < then.face_count(); ++face) {
        if (!has_moved(then, now, face))
            continue;
        if (partition.map_of_face[face] != kNone)
            out.maps[partition.map_of_face[face]] = 1;
        Box& box = out.boxes[then.object_of_face[face]];
        for (int c = 0; c < 3; ++c)
            box.add(then.positions[then.corners[face][c]]);
    }
    return out;
}

bool meets(const Box& box, const MapContact& contact, float margin)
{
    const glm::vec3 low = glm::min(contact.a, contact.b) - margin;
    const glm::vec3 high = glm::max(contact.a, contact.b) + margin;
    return glm::all(glm::lessThanEqual(low, box.high)) &&
           glm::all(glm::lessThanEqual(box.low, high));
}

} // namespace

Partition partition_in_motion(const Partition& partition, const TriangleMesh& then,
                              const TriangleMesh& now)
{
    const Moved moved = find_moved(partition, then, now);
    Partition out = partition;
    if (moved.boxes.empty())
        return out;
    for (FaceId face = 0; face < out.face_count(); ++face) {
        if (out.map_of_face[face] == kNone || moved.maps[out.map_of_face[face]] == 0)
            continue;
        out.candidate[face] = 0;
        out.reach[face] = out.self_distance[face] = out.group_radius[face] = 0;
        out.group_of_face[face] = kNone;
    }
    std::erase_if(out.contacts, [&](const MapContact& contact) {
        return moved.maps[contact.map] != 0 ||
               std::any_of(moved.boxes.begin(), moved.boxes.end(), [&](const auto& entry) {
                   return meets(entry.second, contact, 2 * partition.position_error);
               });
    });
    return out;
}

} // namespace hipmap
