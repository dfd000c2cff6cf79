#include "preprocess/partition/local_candidates.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace hipmap {
namespace {

using Corners = std::array<glm::dvec3, 3>;

/// Sine of the angle at `apex` between the directions to two other points, 1 if it is obtuse.
/// area2: twice the area of the triangle.
double sine_or_one(const glm::dvec3& apex, const glm::dvec3& p, const glm::dvec3& q, double area2)
{
    if (glm::dot(p - apex, q - apex) <= 0)
        return 1;
    return area2 / (glm::length(p - apex) * glm::length(q - apex));
}

double area2_of(const Corners& p)
{
    return glm::length(glm::cross(p[1] - p[0], p[2] - p[0]));
}

/// Distance of `corner` from the segment between the other two: the height, or where its foot lies
/// outside the segment, the longer distance to the end with the obtuse angle.
double reach_of_one(const Corners& p, int corner)
{
    const glm::dvec3& from = p[(corner + 1) % 3];
    const glm::dvec3& to = p[(corner + 2) % 3];
    const double area2 = area2_of(p);
    return std::max(glm::length(p[corner] - from) * sine_or_one(from, to, p[corner], area2),
                    glm::length(p[corner] - to) * sine_or_one(to, from, p[corner], area2));
}

/// Where both edges are equally far, on the edge that is not chosen, from corner `open` on.
double reach_of_two(const Corners& p, int open)
{
    const glm::dvec3& a = p[open];
    const glm::dvec3& b = p[(open + 1) % 3];
    const glm::dvec3& apex = p[(open + 2) % 3];
    const double area2 = area2_of(p);
    const double sine_a = sine_or_one(a, apex, b, area2);
    const double sine_b = sine_or_one(b, apex, a, area2);
    return glm::length(b - a) * sine_a * sine_b / (sine_a + sine_b);
}

} // namespace

double reach_of(const Corners& corners, const std::array<bool, 3>& connected)
{
    const auto count = std::ranges::count(connected, true);
    if (count == 0)
        return std::numeric_limits<double>::infinity();
    if (count == 1) {
        const auto edge = std::ranges::find(connected, true) - connected.begin();
        return reach_of_one(corners, static_cast<int>(edge + 2) % 3);
    }
    if (count == 2) {
        const auto edge = std::ranges::find(connected, false) - connected.begin();
        return reach_of_two(corners, static_cast<int>(edge));
    }
    const double perimeter = glm::length(corners[1] - corners[0]) +
                             glm::length(corners[2] - corners[1]) +
                             glm::length(corners[0] - corners[2]);
    return area2_of(corners) / perimeter;
}

double widest_filter_radius(double area)
{
    return std::sqrt(area / (kPhotonsPerNeighbour * std::numbers::pi));
}

LocalCandidates find_local_candidates(const TriangleMesh& mesh,
                                      std::span<const EdgeClass> edge_class, const SharedMaps& maps)
{
    std::vector<std::uint32_t> faces_of_map(maps.count, 0);
    for (const MapId map : maps.map_of_face)
        if (map != kNone)
            ++faces_of_map[map];

    LocalCandidates out;
    out.reach.assign(mesh.face_count(), 0.0f);
    out.candidate.assign(mesh.face_count(), 0);
    tbb::parallel_for(std::size_t{0}, mesh.face_count(), [&](std::size_t face) {
        if (maps.map_of_face[face] == kNone)
            return;
        Corners corners;
        std::array<bool, 3> connected{};
        for (int c = 0; c < 3; ++c) {
            corners[c] = glm::dvec3(mesh.positions[mesh.corners[face][c]]);
            connected[c] = edge_class[3 * face + c] == EdgeClass::connected;
        }
        const double reach = reach_of(corners, connected);
        const double area = face_area(mesh, static_cast<FaceId>(face));
        out.reach[face] = static_cast<float>(reach);
        out.candidate[face] =
            faces_of_map[maps.map_of_face[face]] > 1 && reach > widest_filter_radius(area);
    });
    return out;
}

} // namespace hipmap
