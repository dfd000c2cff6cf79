#include "preprocess/partition/contact_face.h"

#include <algorithm>
#include <limits>

namespace hipmap {
namespace {

/// Cuts from the interval where a function that is linear along it is below zero.
void keep_positive(Interval& interval, double at_begin, double at_end)
{
    if (at_begin < 0 && at_end < 0)
        interval.end = -std::numeric_limits<double>::infinity();
    else if (at_begin < 0)
        interval.begin = std::max(interval.begin, at_begin / (at_begin - at_end));
    else if (at_end < 0)
        interval.end = std::min(interval.end, at_begin / (at_begin - at_end));
}

/// Where the outline of `f` meets the plane of `g`: at two points of a line, by their place along
/// `direction`.  Empty unless a corner lies clearly on either side.
std::optional<std::array<glm::dvec3, 2>> cut(const ContactFace& f, const ContactFace& g,
                                             const glm::dvec3& direction)
{
    std::array<double, 3> height;
    for (int c = 0; c < 3; ++c)
        height[c] = g.height(f.corners[c]);
    const auto [least, largest] = std::ranges::minmax(height);
    if (!(least < -4 * g.error && largest > 4 * g.error))
        return {};
    std::array<glm::dvec3, 2> ends;
    int count = 0;
    for (int c = 0; c < 3; ++c) {
        const double h = height[c];
        const double h_next = height[(c + 1) % 3];
        if ((h < 0) != (h_next < 0) && count < 2)
            ends[count++] =
                f.corners[c] + h / (h - h_next) * (f.corners[(c + 1) % 3] - f.corners[c]);
    }
    if (glm::dot(ends[1] - ends[0], direction) < 0)
        std::swap(ends[0], ends[1]);
    return ends;
}

} // namespace

ContactFace::ContactFace(const TriangleMesh& mesh, FaceId face, double error_)
    : normal(glm::normalize(scaled_normal(mesh, face))),
      least_height(std::numeric_limits<double>::infinity()), error(error_)
{
    for (int c = 0; c < 3; ++c) {
        corners[c] = glm::dvec3(mesh.positions[mesh.corners[face][c]]);
        planes[c] = edge_plane(mesh, face, c);
    }
    for (int c = 0; c < 3; ++c)
        least_height = std::min(least_height, planes[c].height(corners[(c + 2) % 3]));
}

std::optional<Interval> ContactFace::part_on(const glm::dvec3& a, const glm::dvec3& b) const
{
    const double h_a = height(a);
    const double h_b = height(b);
    if (std::min(h_a, h_b) > 2 * error || std::max(h_a, h_b) < -2 * error) // as most are
        return {};
    Interval part;
    keep_positive(part, h_a + 2 * error, h_b + 2 * error);
    keep_positive(part, 2 * error - h_a, 2 * error - h_b);
    for (const EdgePlane& plane : planes)
        keep_positive(part, plane.height(a) + error, plane.height(b) + error);
    if (!((part.end - part.begin) * glm::length(b - a) > least_length()))
        return {};
    return part;
}

bool parallel(const ContactFace& f, const ContactFace& g)
{
    const double sine = glm::length(glm::cross(f.normal, g.normal));
    return sine <= 8 * f.error * (1 / f.least_height + 1 / g.least_height);
}

std::optional<ContactLine> crossing(const ContactFace& f, const ContactFace& g)
{
    const glm::dvec3 direction = glm::cross(f.normal, g.normal);
    const auto on_f = cut(f, g, direction);
    const auto on_g = on_f ? cut(g, f, direction) : on_f;
    if (!on_g)
        return {};
    const auto place = [&](const glm::dvec3& p) { return glm::dot(p, direction); };
    const ContactLine line{place((*on_f)[0]) > place((*on_g)[0]) ? (*on_f)[0] : (*on_g)[0],
                           place((*on_f)[1]) < place((*on_g)[1]) ? (*on_f)[1] : (*on_g)[1]};
    if (!(place(line.b) > place(line.a)) || !(glm::length(line.b - line.a) > f.least_length()))
        return {};
    return line;
}

} // namespace hipmap
