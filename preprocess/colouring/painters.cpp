#include "preprocess/colouring/painters.h"

#include "common/image/colour_scale.h"
#include "common/partition/limiting_radius.h"
#include "preprocess/colouring/map_colours.h"

#include <algorithm>
#include <array>
#include <optional>

namespace hipmap {

namespace {

/// What a group's colour is multiplied by where its limiting radius is 0.
constexpr float kRim = 0.2f;

/// Half the width of a line, scene units.  A line between two visible faces is drawn half on each;
/// a border has one face for all of it.  Lines within a map are thinner, and thinner still on faces
/// that they would hide.
float half_width(EdgeClass edge_class, float reach, float pixel)
{
    switch (edge_class) {
    case EdgeClass::connected:
        return std::min(0.5f * pixel, 0.15f * reach);
    case EdgeClass::unconnected:
        return 0.75f * pixel;
    default:
        return 1.5f * pixel;
    }
}

/// Distance from `point` to the segment as they appear along `direction`.
float seen_distance(const SeenPoint& point, const glm::vec3& from, const glm::vec3& to)
{
    const auto flat = [&](const glm::vec3& p) {
        const glm::vec3 offset = p - point.position;
        return offset - point.direction * glm::dot(offset, point.direction);
    };
    const glm::vec3 a = flat(from);
    const glm::vec3 along = flat(to) - a;
    const float length2 = glm::dot(along, along);
    const float t = length2 > 0 ? std::clamp(-glm::dot(a, along) / length2, 0.0f, 1.0f) : 0.0f;
    return glm::length(a + along * t);
}

std::optional<EdgeClass> line_at(const TriangleMesh& mesh, const Partition& partition,
                                 const SeenPoint& point)
{
    std::optional<EdgeClass> line;
    for (std::uint32_t c = 0; c < 3; ++c) {
        const EdgeClass edge_class = partition.edge_class[std::size_t{3} * point.face + c];
        const glm::uvec3& corners = mesh.corners[point.face];
        const glm::vec3& from = mesh.positions[corners[static_cast<int>(c)]];
        const glm::vec3& to = mesh.positions[corners[static_cast<int>((c + 1) % 3)]];
        const float width = half_width(edge_class, partition.reach[point.face], point.pixel);
        if (seen_distance(point, from, to) < width)
            line = line ? std::max(*line, edge_class) : edge_class;
    }
    return line;
}

} // namespace

Rgb edge_colour(EdgeClass edge_class)
{
    static constexpr std::array<Rgb, 5> kColours{
        Rgb(0.10f, 0.42f, 0.75f), // connected: blue
        Rgb(0.02f, 0.02f, 0.02f), // unconnected: black
        Rgb(0.90f, 0.30f, 0.00f), // border: orange
        Rgb(0.75f, 0.00f, 0.45f), // non-manifold: magenta
        Rgb(0.00f, 0.35f, 0.05f), // degenerate: green
    };
    return kColours[static_cast<std::size_t>(edge_class)];
}

Painter paint_maps(const Partition& partition)
{
    return [&partition, colours = map_colours(partition)](const SeenPoint& point) {
        const MapId map = partition.map_of_face[point.face];
        return map == kNone ? kPlainFace : colours[map];
    };
}

Painter paint_edges(const TriangleMesh& mesh, const Partition& partition)
{
    return [&mesh, &partition](const SeenPoint& point) {
        const std::optional<EdgeClass> line = line_at(mesh, partition, point);
        return line ? edge_colour(*line) : Rgb(0.75f);
    };
}

PhotonRange photons_of_candidates(const Partition& partition, std::span<const float> photons)
{
    PhotonRange range;
    for (std::size_t face = 0; face < photons.size(); ++face) {
        if (!partition.candidate[face])
            continue;
        range.least = range.largest > 0 ? std::min(range.least, photons[face]) : photons[face];
        range.largest = std::max(range.largest, photons[face]);
    }
    return range;
}

Painter paint_candidates(const Partition& partition, std::span<const float> photons)
{
    const PhotonRange range = photons_of_candidates(partition, photons);
    return [&partition, photons, range](const SeenPoint& point) {
        if (!partition.candidate[point.face])
            return kPlainFace;
        if (photons.empty())
            return scale_colour(1.0);
        const double octaves = std::log2(double{range.largest} / range.least);
        const double above = std::log2(double{photons[point.face]} / range.least);
        return scale_colour(octaves > 0 ? above / octaves : 1.0);
    };
}

Painter paint_groups(const TriangleMesh& mesh, const Partition& partition)
{
    std::vector<float> largest(partition.group_count, 0.0f);
    for (FaceId face = 0; face < partition.face_count(); ++face)
        if (const std::uint32_t group = partition.group_of_face[face]; group != kNone)
            largest[group] = std::max(largest[group], partition.group_radius[face]);
    return [&mesh, &partition, largest = std::move(largest),
            colours = group_colours(partition)](const SeenPoint& point) {
        const std::uint32_t group = partition.group_of_face[point.face];
        if (group == kNone)
            return kPlainFace;
        const float radius = exact_group_radius(mesh, partition, point.face, point.position);
        return colours[group] * (kRim + (1 - kRim) * radius / largest[group]);
    };
}

} // namespace hipmap
