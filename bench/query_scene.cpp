#include "bench/query_scene.h"

#include "common/math/random.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hipmap {

namespace {

struct Rectangle {
    glm::vec3 corner, u, v;
};

/// The six sides of a box, or without its bottom.
void append_box(const glm::vec3& low, const glm::vec3& size, bool bottom,
                std::vector<Rectangle>& out)
{
    const glm::vec3 x(size.x, 0, 0), y(0, size.y, 0), z(0, 0, size.z);
    if (bottom)
        out.push_back({low, x, z});
    out.push_back({low + y, x, z});
    out.push_back({low, x, y});
    out.push_back({low + z, x, y});
    out.push_back({low, z, y});
    out.push_back({low + x, z, y});
}

const std::vector<Rectangle>& room()
{
    static const std::vector<Rectangle> rectangles = [] {
        std::vector<Rectangle> out;
        append_box({0, 0, 0}, {1, 0.7f, 1}, true, out);
        append_box({0.1f, 0, 0.6f}, {0.2f, 0.3f, 0.2f}, false, out);
        append_box({0.45f, 0, 0.7f}, {0.1f, 0.5f, 0.1f}, false, out);
        append_box({0.7f, 0, 0.5f}, {0.2f, 0.1f, 0.3f}, false, out);
        append_box({0.35f, 0, 0.4f}, {0.15f, 0.15f, 0.15f}, false, out);
        append_box({0.8f, 0, 0.85f}, {0.1f, 0.4f, 0.1f}, false, out);
        return out;
    }();
    return rectangles;
}

struct Spot {
    std::uint32_t map;
    glm::vec2 centre; ///< fractions of the sides
    float radius;
};

constexpr std::array<Spot, 4> kSpots{{{0, {0.6f, 0.3f}, 0.06f},
                                      {3, {0.3f, 0.5f}, 0.04f},
                                      {1, {0.5f, 0.8f}, 0.08f},
                                      {6, {0.5f, 0.5f}, 0.05f}}};
constexpr float kEven = 0.62f;

RoomPoint point_at(std::uint32_t map, const glm::vec2& at)
{
    const Rectangle& r = room()[map];
    const glm::vec2 t = glm::clamp(at, 0.0f, 1.0f);
    return {r.corner + t.x * r.u + t.y * r.v, map};
}

std::vector<float> cumulative_areas()
{
    std::vector<float> sums;
    float sum = 0;
    for (const Rectangle& r : room())
        sums.push_back(sum += glm::length(r.u) * glm::length(r.v));
    return sums;
}

RoomPoint photon(RandomSequence& random, const std::vector<float>& areas)
{
    if (random.next() < kEven) {
        const float at = random.next() * areas.back();
        const auto map = std::upper_bound(areas.begin(), areas.end() - 1, at) - areas.begin();
        return point_at(static_cast<std::uint32_t>(map), random.next2());
    }
    const Spot& spot = kSpots[static_cast<std::size_t>(random.next() * kSpots.size())];
    const Rectangle& r = room()[spot.map];
    const float radius = spot.radius * std::sqrt(random.next());
    const float angle = glm::two_pi<float>() * random.next();
    return point_at(spot.map, spot.centre + radius * glm::vec2(std::cos(angle) / glm::length(r.u),
                                                               std::sin(angle) / glm::length(r.v)));
}

RoomPoint nearest_hit(const glm::vec3& from, const glm::vec3& direction)
{
    float nearest = std::numeric_limits<float>::infinity();
    RoomPoint hit{from, 0};
    for (std::uint32_t map = 0; map < room().size(); ++map) {
        const Rectangle& r = room()[map];
        const glm::vec3 normal = glm::cross(r.u, r.v);
        const float t = glm::dot(r.corner - from, normal) / glm::dot(direction, normal);
        const glm::vec3 d = from + t * direction - r.corner;
        const glm::vec2 at(glm::dot(d, r.u) / glm::dot(r.u, r.u),
                           glm::dot(d, r.v) / glm::dot(r.v, r.v));
        if (t > 0 && t < nearest && glm::all(glm::greaterThanEqual(at, glm::vec2(0))) &&
            glm::all(glm::lessThanEqual(at, glm::vec2(1)))) {
            nearest = t;
            hit = point_at(map, at);
        }
    }
    return hit;
}

/// Every third bit.
std::uint64_t spread_bits(float coordinate)
{
    auto x = static_cast<std::uint64_t>(glm::clamp(coordinate, 0.0f, 1.0f) * 0x1fffff);
    x = (x | x << 32) & 0x1f00000000ffffull;
    x = (x | x << 16) & 0x1f0000ff0000ffull;
    x = (x | x << 8) & 0x100f00f00f00f00full;
    x = (x | x << 4) & 0x10c30c30c30c30c3ull;
    return (x | x << 2) & 0x1249249249249249ull;
}

} // namespace

std::vector<RoomPoint> room_photons(std::size_t count)
{
    const std::vector<float> areas = cumulative_areas();
    std::vector<RoomPoint> photons;
    photons.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        RandomSequence random(1, RandomStream::photons, 0, i);
        photons.push_back(photon(random, areas));
    }
    return photons;
}

std::vector<RoomPoint> room_picture(int width, int height)
{
    std::vector<RoomPoint> points;
    points.reserve(std::size_t(width) * std::size_t(height));
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float right = (float(x) + 0.5f) / float(width) - 0.5f;
            const float down = (float(y) + 0.5f - 0.5f * float(height)) / float(width);
            points.push_back(
                nearest_hit({0.5f, 0.45f, 0.01f}, {1.2f * right, -1.2f * down - 0.1f, 1.0f}));
        }
    return points;
}

void sort_by_morton_code(std::vector<RoomPoint>& points)
{
    std::vector<std::pair<std::uint64_t, std::uint32_t>> order;
    order.reserve(points.size());
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        const glm::vec3& p = points[i].position;
        order.emplace_back(spread_bits(p.x) << 2 | spread_bits(p.y) << 1 | spread_bits(p.z), i);
    }
    std::sort(order.begin(), order.end());
    std::vector<RoomPoint> sorted;
    sorted.reserve(points.size());
    for (const auto& [code, i] : order)
        sorted.push_back(points[i]);
    points = std::move(sorted);
}

} // namespace hipmap
