#pragma once

#include "common/math/random.h"
#include "render/maps/visible_disc.h"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <utility>

namespace hipmap::flat_walls {

inline constexpr double kPiD = std::numbers::pi;
using Segments = std::vector<BoundarySegment>;

/// A face in the plane z = 0 with `point` well inside.
inline DiscQuery flat_query(float x, float y, float radius)
{
    return {{glm::vec3(x - 2, y - 1, 0), {x + 2, y - 1, 0}, {x, y + 2, 0}}, {x, y, 0}, radius};
}

inline BoundarySegment flat(float ax, float ay, float bx, float by)
{
    return {{ax, ay, 0}, {bx, by, 0}};
}

/// A line through (x, y) along (dx, dy), long enough.
inline BoundarySegment line(float x, float y, float dx, float dy)
{
    return flat(x - 64 * dx, y - 64 * dy, x + 64 * dx, y + 64 * dy);
}

inline VisibleDisc look(const DiscQuery& query, const Segments& segments)
{
    VisibleDisc disc;
    disc.look(query, segments);
    return disc;
}

/// Share of the disc of radius r about `centre` that is seen.  rotation: takes z = 0 to its plane.
inline double seen_share(const VisibleDisc& disc, const glm::vec3& centre, float r, int n = 160,
                         const glm::quat& rotation = {1, 0, 0, 0})
{
    int seen = 0, all = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const glm::vec2 u = (glm::vec2(i, j) + 0.5f) * (2.0f / n) - 1.0f;
            if (glm::dot(u, u) > 1)
                continue;
            ++all;
            seen += disc.sees(centre + rotation * glm::vec3(r * u, 0));
        }
    return double(seen) / all;
}

/// Numbers for the trials of a test.
class Random {
  public:
    explicit Random(std::uint64_t seed) : sequence_(seed, RandomStream::pictures, 0, 0) {}
    float between(float low, float high) { return low + (high - low) * sequence_.next(); }
    std::size_t below(std::size_t n) { return static_cast<std::size_t>(sequence_.next() * n); }
    glm::quat rotation()
    {
        const auto u = [&] { return between(-1, 1); };
        return glm::normalize(glm::quat(u() + 0.01f, u(), u(), u()));
    }
    template <typename Items>
    void shuffle(Items& items)
    {
        for (std::size_t i = items.size(); i > 1; --i)
            std::swap(items[i - 1], items[below(i)]);
    }

  private:
    RandomSequence sequence_;
};

/// Segments of all lengths anywhere; every third starts where the last one ended.
inline Segments random_segments(Random& random, int count)
{
    Segments out;
    for (int i = 0; i < count; ++i) {
        const float x = random.between(-1.2f, 1.2f), y = random.between(-1.2f, 1.2f);
        const float size = random.between(0, 1) < 0.5f ? 0.2f : 2.0f;
        out.push_back(flat(x, y, x + random.between(-size, size), y + random.between(-size, size)));
        if (i % 3 == 2)
            out[i].a = out[i - 1].b;
    }
    return out;
}

} // namespace hipmap::flat_walls
