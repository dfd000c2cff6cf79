#include "preprocess/mesh/weld_vertices.h"

#include "common/math/random.h"
#include "common/scene/mesh.h"

#include <bit>

namespace hipmap {
namespace {

std::uint64_t hash_of(const glm::vec3& p)
{
    const auto bits = [](float value) {
        return std::uint64_t{std::bit_cast<std::uint32_t>(value + 0.0f)}; // -0 + 0 is 0
    };
    return mix_bits(mix_bits(bits(p.x) << 32 | bits(p.y)) ^ bits(p.z));
}

} // namespace

VertexWeld weld_vertices(std::span<const glm::vec3> positions)
{
    VertexWeld weld;
    weld.id_of_vertex.resize(positions.size());
    // Open addressing, at most half full: slots hold the first vertex at each position.
    const std::size_t slots = std::bit_ceil(2 * positions.size() + 1);
    std::vector<std::uint32_t> first_vertex(slots, kNone);
    for (std::uint32_t vertex = 0; vertex < positions.size(); ++vertex) {
        std::size_t slot = hash_of(positions[vertex]) & (slots - 1);
        while (first_vertex[slot] != kNone && positions[first_vertex[slot]] != positions[vertex])
            slot = (slot + 1) & (slots - 1);
        if (first_vertex[slot] == kNone) {
            first_vertex[slot] = vertex;
            weld.id_of_vertex[vertex] = weld.count++;
        } else {
            weld.id_of_vertex[vertex] = weld.id_of_vertex[first_vertex[slot]];
        }
    }
    return weld;
}

} // namespace hipmap
