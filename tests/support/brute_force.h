#pragma once

#include "render/dissertation/neighbour_heap.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <functional>
#include <vector>

namespace hipmap::brute_force {

/// The k nearest of the points that pass, nearest first, ties by index: sorts them all.
inline std::vector<Neighbour> k_nearest(const std::vector<glm::vec3>& points,
                                        const glm::vec3& query, std::size_t k, float radius,
                                        const std::function<bool(std::uint32_t)>& passes)
{
    std::vector<Neighbour> all;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::vec3 d = points[i] - query;
        const Neighbour neighbour{glm::dot(d, d), static_cast<std::uint32_t>(i)};
        if (neighbour.distance2 <= radius * radius && passes(neighbour.photon))
            all.push_back(neighbour);
    }
    std::sort(all.begin(), all.end());
    all.resize(std::min(k, all.size()));
    return all;
}

inline bool same(std::span<const Neighbour> a, std::span<const Neighbour> b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const Neighbour& x, const Neighbour& y) {
                          return x.photon == y.photon && x.distance2 == y.distance2;
                      });
}

} // namespace hipmap::brute_force
