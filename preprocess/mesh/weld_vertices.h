#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace hipmap {

/// One id per position of a mesh whose file splits vertices at seams.
struct VertexWeld {
    std::vector<std::uint32_t> id_of_vertex; ///< [V]
    std::uint32_t count = 0;                 ///< ids: 0..count-1 by lowest vertex
};

/// Gives vertices with bit-identical positions one id; -0 counts as 0. distance: 0 keeps near
/// positions apart; above 0, a position takes the id of the nearest position kept before it within
/// the distance, and is kept otherwise.  positions: finite, any unit. Linear; parallel up to a
/// distance of 0.
VertexWeld weld_vertices(std::span<const glm::vec3> positions, double distance = 0.0);

/// Does the same with a thread for each of `parts`, 1 to 256, into which positions are divided by
/// hash; the result does not depend on it.
VertexWeld weld_vertices(std::span<const glm::vec3> positions, double distance, std::size_t parts);

} // namespace hipmap
