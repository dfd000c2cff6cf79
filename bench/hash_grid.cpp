#include "bench/hash_grid.h"

#include <bit>

namespace hipmap {

HashGrid::HashGrid(std::span<const Item> items, float radius)
    : radius_(radius), mask_(std::bit_ceil(static_cast<std::uint32_t>(items.size()) + 1) - 1),
      first_(std::size_t{mask_} + 2, 0), items_(items.size())
{
    for (const Item& item : items)
        ++first_[bucket(cell_of(item.position)) + 1];
    for (std::size_t b = 0; b <= mask_; ++b)
        first_[b + 1] += first_[b];
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (const Item& item : items)
        items_[next[bucket(cell_of(item.position))]++] = item;
}

std::uint32_t HashGrid::bucket(const glm::ivec3& cell) const
{
    const glm::uvec3 c(cell);
    return (c.x * 73856093u ^ c.y * 19349663u ^ c.z * 83492791u) & mask_;
}

glm::ivec3 HashGrid::cell_of(const glm::vec3& point) const
{
    return glm::ivec3(glm::floor(point / (2 * radius_)));
}

HashGrid::Sum HashGrid::within(const glm::vec3& point) const
{
    Sum sum;
    const glm::ivec3 low = cell_of(point - radius_);
    std::uint32_t seen[8];
    for (int i = 0; i < 8; ++i) {
        seen[i] = bucket(low + glm::ivec3(i & 1, i >> 1 & 1, i >> 2));
        bool again = false; // two cells may share a bucket
        for (int j = 0; j < i; ++j)
            again = again || seen[j] == seen[i];
        if (again)
            continue;
        for (std::uint32_t k = first_[seen[i]]; k < first_[seen[i] + 1]; ++k) {
            const glm::vec3 d = items_[k].position - point;
            if (glm::dot(d, d) <= radius_ * radius_) {
                sum.power += items_[k].power;
                ++sum.photons;
            }
        }
    }
    return sum;
}

} // namespace hipmap
