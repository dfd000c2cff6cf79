#include "preprocess/mesh/weld_vertices.h"

#include "common/math/random.h"
#include "common/scene/mesh.h"
#include "preprocess/mesh/parts.h"

#include <bit>
#include <unordered_map>
#include <utility>

namespace hipmap {
namespace {

std::uint64_t hash_of(const glm::vec3& p)
{
    const auto bits = [](float value) {
        return std::uint64_t{std::bit_cast<std::uint32_t>(value + 0.0f)}; // -0 + 0 is 0
    };
    return mix_bits(mix_bits(bits(p.x) << 32 | bits(p.y)) ^ bits(p.z));
}

/// Positions that are farther apart than a distance, in cubes of that size: a cube and those around
/// it hold a bounded number of them.
class SparsePositions {
  public:
    explicit SparsePositions(double distance) : distance_(distance) {}

    /// The id of the nearest one within the distance; kNone if there is none.
    std::uint32_t nearest(const glm::dvec3& position) const
    {
        const glm::dvec3 cell = glm::floor(position / distance_);
        double least = distance_;
        std::uint32_t found = kNone;
        for (int i = 0; i < 27; ++i) {
            const glm::dvec3 offset(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
            const auto [begin, end] = cells_.equal_range(hash_of(cell + offset));
            for (auto it = begin; it != end; ++it) {
                const auto& [other, id] = it->second;
                const double apart = glm::length(other - position);
                if (apart < least || (apart == least && id < found)) {
                    least = apart;
                    found = id;
                }
            }
        }
        return found;
    }

    void keep(const glm::dvec3& position, std::uint32_t id)
    {
        cells_.emplace(hash_of(glm::floor(position / distance_)), std::pair(position, id));
    }

  private:
    static std::uint64_t hash_of(const glm::dvec3& cell)
    {
        const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value + 0.0); };
        return mix_bits(mix_bits(mix_bits(bits(cell.x)) + bits(cell.y)) + bits(cell.z));
    }

    double distance_;
    std::unordered_multimap<std::uint64_t, std::pair<glm::dvec3, std::uint32_t>> cells_;
};

/// Welds the positions of a weld further.
VertexWeld weld_near(std::span<const glm::vec3> positions, const VertexWeld& exact, double distance)
{
    VertexWeld weld;
    weld.id_of_vertex.resize(positions.size());
    std::vector<std::uint32_t> id_of_exact(exact.count, kNone);
    SparsePositions kept(distance);
    for (std::size_t vertex = 0; vertex < positions.size(); ++vertex) {
        std::uint32_t& id = id_of_exact[exact.id_of_vertex[vertex]];
        const glm::dvec3 position(positions[vertex]);
        if (id == kNone)
            id = kept.nearest(position);
        if (id == kNone) {
            id = weld.count++;
            kept.keep(position, id);
        }
        weld.id_of_vertex[vertex] = id;
    }
    return weld;
}

/// Gives each vertex of one part of the positions, by hash, the first vertex at its position.
/// part_of_vertex: [V]; empty: all are in one part.
void find_first_vertices(std::span<const glm::vec3> positions, std::size_t part,
                         std::span<const std::uint8_t> part_of_vertex, std::size_t count,
                         std::vector<std::uint32_t>& first_of_vertex)
{
    // Open addressing, at most half full: slots hold the first vertex at each position.
    const std::size_t slots = std::bit_ceil(2 * count + 1);
    std::vector<std::uint32_t> first(slots, kNone);
    for (std::uint32_t vertex = 0; vertex < positions.size(); ++vertex) {
        if (!part_of_vertex.empty() && part_of_vertex[vertex] != part)
            continue;
        std::size_t slot = hash_of(positions[vertex]) & (slots - 1);
        while (first[slot] != kNone && positions[first[slot]] != positions[vertex])
            slot = (slot + 1) & (slots - 1);
        if (first[slot] == kNone)
            first[slot] = vertex;
        first_of_vertex[vertex] = first[slot];
    }
}

/// Divides positions into parts by hash; returns how many are in each.
std::vector<std::size_t> divide(std::span<const glm::vec3> positions,
                                std::span<std::uint8_t> part_of_vertex, std::size_t parts)
{
    std::vector<std::vector<std::size_t>> counts(parts, std::vector<std::size_t>(parts, 0));
    for_each_part(parts, [&](std::size_t i) {
        const Part part = part_of(positions.size(), i, parts);
        for (std::size_t vertex = part.begin; vertex < part.end; ++vertex) {
            const std::uint64_t high_bits = hash_of(positions[vertex]) >> 32; // slots go by the low
            part_of_vertex[vertex] = static_cast<std::uint8_t>(high_bits * parts >> 32);
            ++counts[i][part_of_vertex[vertex]];
        }
    });
    std::vector<std::size_t> out(parts, 0);
    for (const std::vector<std::size_t>& some : counts)
        for (std::size_t part = 0; part < parts; ++part)
            out[part] += some[part];
    return out;
}

VertexWeld weld_identical(std::span<const glm::vec3> positions, std::size_t parts)
{
    VertexWeld weld;
    weld.id_of_vertex.resize(positions.size());
    std::vector<std::uint8_t> part_of_vertex(parts > 1 ? positions.size() : 0);
    std::vector<std::size_t> counts{positions.size()};
    if (parts > 1)
        counts = divide(positions, part_of_vertex, parts);
    for_each_part(parts, [&](std::size_t part) {
        find_first_vertices(positions, part, part_of_vertex, counts[part], weld.id_of_vertex);
    });
    for (std::uint32_t vertex = 0; vertex < positions.size(); ++vertex) {
        const std::uint32_t first = weld.id_of_vertex[vertex];
        weld.id_of_vertex[vertex] = first == vertex ? weld.count++ : weld.id_of_vertex[first];
    }
    return weld;
}

} // namespace

VertexWeld weld_vertices(std::span<const glm::vec3> positions, double distance)
{
    return weld_vertices(positions, distance, parts_for(positions.size()));
}

VertexWeld weld_vertices(std::span<const glm::vec3> positions, double distance, std::size_t parts)
{
    VertexWeld weld = weld_identical(positions, parts);
    return distance > 0 ? weld_near(positions, weld, distance) : weld;
}

} // namespace hipmap
