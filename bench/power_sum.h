#pragma once

#include "render/dissertation/neighbour_heap.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace hipmap {

/// The powers of photons, red, green and blue; the fourth component fills a vector register.
using Powers = std::vector<glm::vec4>;

/// Sums the powers at `place(element)`, in four sums that do not wait for each other.
template <typename Found, typename Place>
glm::vec4 sum_powers(const Powers& powers, std::span<const Found> found, const Place& place)
{
    glm::vec4 a(0.0f), b(0.0f), c(0.0f), d(0.0f);
    std::size_t i = 0;
    for (; i + 4 <= found.size(); i += 4) {
        a += powers[place(found[i])];
        b += powers[place(found[i + 1])];
        c += powers[place(found[i + 2])];
        d += powers[place(found[i + 3])];
    }
    for (; i < found.size(); ++i)
        a += powers[place(found[i])];
    return (a + b) + (c + d);
}

inline glm::vec4 sum_powers(const Powers& powers, std::span<const Neighbour> found)
{
    return sum_powers(powers, found, [](const Neighbour& neighbour) { return neighbour.photon; });
}

inline glm::vec4 sum_powers(const Powers& powers, std::span<const std::uint32_t> found)
{
    return sum_powers(powers, found, [](std::uint32_t photon) { return photon; });
}

} // namespace hipmap
