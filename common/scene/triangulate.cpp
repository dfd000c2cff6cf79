#include "common/scene/triangulate.h"

#include <cstdint>

namespace hipmap {

namespace {

/// Twice the signed area of a triangle.
double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The polygon in the plane it faces, wound counter-clockwise: along the axis of its normal
/// (Newell's) that is longest, the coordinate is dropped.
std::vector<glm::dvec2> flatten(std::span<const glm::dvec3> points)
{
    glm::dvec3 normal(0.0);
    for (std::size_t i = 0; i < points.size(); ++i)
        normal += glm::cross(points[i] - points[0], points[(i + 1) % points.size()] - points[0]);
    const glm::dvec3 size = glm::abs(normal);
    const int drop = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    int u = (drop + 1) % 3, v = (drop + 2) % 3;
    if (normal[drop] < 0)
        std::swap(u, v);
    std::vector<glm::dvec2> flat;
    flat.reserve(points.size());
    for (const glm::dvec3& p : points)
        flat.emplace_back(p[u], p[v]);
    return flat;
}

/// Turns left at every corner, and round once only: one direction of travel has one maximum in x.
bool is_convex(const std::vector<glm::dvec2>& flat)
{
    const std::size_t n = flat.size();
    std::size_t reversals = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const glm::dvec2 &a = flat[i], &b = flat[(i + 1) % n], &c = flat[(i + 2) % n];
        if (turn(a, b, c) < 0)
            return false;
        reversals += (b.x - a.x < 0) != (c.x - b.x < 0) ? 1 : 0;
    }
    return reversals <= 2;
}

class EarCutter {
  public:
    explicit EarCutter(const std::vector<glm::dvec2>& flat) : flat_(flat)
    {
        for (std::uint32_t i = 0; i < flat.size(); ++i)
            left_.push_back(i);
    }

    std::vector<glm::uvec3> cut()
    {
        std::vector<glm::uvec3> triangles;
        std::size_t at = 0;
        while (left_.size() >= 3) {
            const std::size_t ear = next_ear(at);
            triangles.emplace_back(before(ear), left_[ear], after(ear));
            left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(ear));
            at = ear; // going round keeps the triangles from becoming needles at one corner
        }
        return triangles;
    }

  private:
    std::uint32_t before(std::size_t i) const
    {
        return left_[(i + left_.size() - 1) % left_.size()];
    }
    std::uint32_t after(std::size_t i) const { return left_[(i + 1) % left_.size()]; }

    /// The first ear from `start` on; `start` itself if there is none, so that the cutting ends.
    std::size_t next_ear(std::size_t start) const
    {
        for (std::size_t step = 0; step < left_.size(); ++step) {
            const std::size_t i = (start + step) % left_.size();
            if (is_ear(i))
                return i;
        }
        return start % left_.size();
    }

    bool is_ear(std::size_t i) const
    {
        const std::uint32_t ia = before(i), ib = left_[i], ic = after(i);
        const glm::dvec2 &a = flat_[ia], &b = flat_[ib], &c = flat_[ic];
        if (!(turn(a, b, c) > 0))
            return false;
        for (const std::uint32_t j : left_) {
            if (j == ia || j == ib || j == ic)
                continue;
            const glm::dvec2& p = flat_[j];
            if (p != a && p != b && p != c && turn(a, b, p) >= 0 && turn(b, c, p) >= 0 &&
                turn(c, a, p) >= 0)
                return false;
        }
        return true;
    }

    const std::vector<glm::dvec2>& flat_;
    std::vector<std::uint32_t> left_; ///< corners not yet cut off, in order
};

} // namespace

std::vector<glm::uvec3> triangulate(std::span<const glm::dvec3> points)
{
    const std::vector<glm::dvec2> flat = flatten(points);
    if (!is_convex(flat))
        return EarCutter(flat).cut();
    std::vector<glm::uvec3> fan;
    for (std::uint32_t i = 2; i < points.size(); ++i)
        fan.emplace_back(0u, i - 1, i);
    return fan;
}

} // namespace hipmap
