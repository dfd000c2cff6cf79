#pragma once

#include "common/math/random.h"

#include <glm/glm.hpp>

#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace hipmap::point_sets {

inline constexpr float kFar = std::numeric_limits<float>::infinity();

using Points = std::vector<glm::vec3>;
using Place = std::function<glm::vec3(RandomSequence&)>;

inline glm::vec3 anywhere(RandomSequence& random)
{
    return {random.next(), random.next(), random.next()};
}

/// Sets on which a tree could go wrong.
inline const std::vector<std::pair<const char*, Place>> kPlaces = {
    {"cloud", anywhere},
    {"plane", [](RandomSequence& r) { return glm::vec3(r.next(), 0.5f, r.next()); }},
    {"line", [](RandomSequence& r) { return glm::vec3(0.25f, 0.5f, r.next()); }},
    {"lattice", [](RandomSequence& r) { return glm::floor(8.0f * anywhere(r)) / 8.0f; }},
    {"one point", [](RandomSequence&) { return glm::vec3(0.5f); }},
    {"clusters",
     [](RandomSequence& r) {
         const float size = r.next() < 0.9f ? 1e-6f : 1.0f;
         return glm::vec3(0.3f) + size * anywhere(r);
     }},
    {"far away", [](RandomSequence& r) { return glm::vec3(1e6f) + anywhere(r); }},
};

inline Points make_points(const Place& place, std::uint64_t seed, std::size_t count)
{
    Points points;
    for (std::size_t i = 0; i < count; ++i) {
        RandomSequence random(seed, RandomStream::pictures, 0, i);
        points.push_back(place(random));
    }
    return points;
}

} // namespace hipmap::point_sets
