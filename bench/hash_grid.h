#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace hipmap {

/// Photons in the cells of an endless grid, the yardstick for searches at a fixed radius.  Cells
/// are found by a hash; the photons of one lie next to each other, position and power together, so
/// that a search reads few cache lines (Teschner et al. 2003; Hachisuka and Jensen 2009 gather with
/// one).
class HashGrid {
  public:
    struct Item {
        glm::vec3 position;
        glm::vec3 power;
    };
    struct Sum {
        glm::dvec3 power{0.0};
        std::uint64_t photons = 0;
    };

    /// radius: of the searches; a cell is twice as wide, so that each looks into eight.
    HashGrid(std::span<const Item> items, float radius);

    /// Sums the photons within the radius.
    Sum within(const glm::vec3& point) const;

  private:
    std::uint32_t bucket(const glm::ivec3& cell) const;
    glm::ivec3 cell_of(const glm::vec3& point) const;

    float radius_;
    std::uint32_t mask_ = 0;
    std::vector<std::uint32_t> first_; ///< [buckets + 1]
    std::vector<Item> items_;          ///< bucket by bucket
};

} // namespace hipmap
