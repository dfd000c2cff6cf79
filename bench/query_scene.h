#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace hipmap {

/// A point on a surface of the room.
struct RoomPoint {
    glm::vec3 position;
    std::uint32_t map; ///< the rectangle it is on
};

inline constexpr std::uint32_t kRoomMaps = 31;

/// Photons in a room with five boxes: 62 % spread evenly over its rectangles, the others in four
/// bright spots.
std::vector<RoomPoint> room_photons(std::size_t count);

/// What the pixels of a picture of the room see, row by row.
std::vector<RoomPoint> room_picture(int width, int height);

/// Orders points along a Morton curve of their positions.
void sort_by_morton_code(std::vector<RoomPoint>& points);

} // namespace hipmap
