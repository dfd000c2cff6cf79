#include "preprocess/partition/polygon_distance.h"

#include <algorithm>
#include <limits>

namespace hipmap {
namespace {

using Points = std::span<const glm::dvec3>;

/// Square of the distance between the segments a to a + u and b to b + v.
/// Ericson 2005, "Real-Time Collision Detection", section 5.1.9.
double segment_distance2(const glm::dvec3& a, const glm::dvec3& u, const glm::dvec3& b,
                         const glm::dvec3& v)
{
    const glm::dvec3 w = a - b;
    const double uu = glm::dot(u, u), vv = glm::dot(v, v), uv = glm::dot(u, v);
    const double uw = glm::dot(u, w), vw = glm::dot(v, w);
    const auto fraction = [](double numerator, double denominator) {
        return denominator > 0 ? std::clamp(numerator / denominator, 0.0, 1.0) : 0.0;
    };
    const double s = fraction(uv * vw - uw * vv, uu * vv - uv * uv);
    const double t = fraction(uv * s + vw, vv);
    const glm::dvec3 off = w + fraction(uv * t - uw, uu) * u - t * v;
    return glm::dot(off, off);
}

/// Whether a point, seen along the normal, lies within the polygon.
bool covers(const ConvexPolygon& polygon, const glm::dvec3& point)
{
    const Points p = polygon.points();
    for (std::size_t i = 0; i < p.size(); ++i) {
        const glm::dvec3 along = p[(i + 1) % p.size()] - p[i];
        if (glm::dot(glm::cross(polygon.normal(), along), point - p[i]) < 0)
            return false;
    }
    return true;
}

/// Square of the least distance of a point of `a`'s outline from the inside of `b`, where the foot
/// of it is a corner of `a` or an edge of `a` goes through `b`.
double face_distance2(const ConvexPolygon& a, const ConvexPolygon& b)
{
    const Points p = a.points();
    const glm::dvec3 origin = b.points()[0];
    const double length2 = glm::dot(b.normal(), b.normal());
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < p.size(); ++i) {
        const glm::dvec3& next = p[(i + 1) % p.size()];
        const double h = glm::dot(p[i] - origin, b.normal());
        const double h_next = glm::dot(next - origin, b.normal());
        if (h * h < least * length2 && covers(b, p[i]))
            least = h * h / length2;
        if ((h < 0) != (h_next < 0) && covers(b, p[i] + h / (h - h_next) * (next - p[i])))
            return 0;
    }
    return least;
}

} // namespace

void ConvexPolygon::clip(const glm::dvec3& origin, const glm::dvec3& inward, double level)
{
    std::array<glm::dvec3, kMostPoints> kept;
    std::size_t kept_count = 0;
    bool any = false;
    for (std::size_t i = 0; i < count_; ++i) {
        const glm::dvec3& from = points_[i];
        const glm::dvec3& to = points_[(i + 1) % count_];
        const double h = glm::dot(from - origin, inward) - level;
        const double h_next = glm::dot(to - origin, inward) - level;
        any |= h > 0;
        if (h > 0)
            kept[kept_count++] = from;
        if ((h > 0) != (h_next > 0))
            kept[kept_count++] = from + h / (h - h_next) * (to - from);
    }
    points_ = kept;
    count_ = any ? kept_count : 0;
}

double distance(const ConvexPolygon& a, const ConvexPolygon& b)
{
    const Points p = a.points();
    const Points q = b.points();
    double least = std::min(face_distance2(a, b), face_distance2(b, a));
    for (std::size_t i = 0; i < p.size() && least > 0; ++i)
        for (std::size_t j = 0; j < q.size(); ++j)
            least = std::min(least, segment_distance2(p[i], p[(i + 1) % p.size()] - p[i], q[j],
                                                      q[(j + 1) % q.size()] - q[j]));
    return std::sqrt(least);
}

} // namespace hipmap
