#pragma once

#include "preprocess/partition/build_partition.h"
#include "tests/support/placed_mesh.h"

#include <algorithm>
#include <map>
#include <set>
#include <span>

namespace hipmap::tiny {

/// A scene as loaded, and its partition.
struct Partitioned {
    Scene scene;
    Partition partition;

    explicit Partitioned(const GltfFile& file)
        : scene(load(file).scene), partition(build_partition(scene, {}).partition)
    {
    }

    double metres(double length) const { return length * scene.frame.metres_per_unit; }
    glm::dvec3 metres(const glm::vec3& point) const
    {
        return scene.frame.centre + scene.frame.metres_per_unit * glm::dvec3(point);
    }
    /// Where an edge begins, in metres.
    glm::dvec3 start(std::uint32_t edge) const
    {
        return world(scene, scene.mesh.corners[edge / 3][static_cast<int>(edge % 3)]);
    }
};

/// The edge after another one round their face.
inline std::uint32_t next_edge(std::uint32_t edge)
{
    return edge - edge % 3 + (edge % 3 + 1) % 3;
}

/// The largest limiting radius of any point of a face, in metres: the largest height over the kept
/// edges, unless the self-distance is less; docs/partition_file.md (4).
inline double best_radius(const Partitioned& of, FaceId face)
{
    const unsigned kept = of.partition.kept_edges[face];
    const double area2 = 2 * face_area(of.scene.mesh, face);
    double perimeter = 0, inverse_heights = 0;
    for (std::uint32_t c = 0; c < 3; ++c) {
        const std::uint32_t edge = 3 * face + c;
        const double length = glm::distance(of.start(edge), of.start(next_edge(edge)));
        perimeter += length / of.scene.frame.metres_per_unit;
        if (kept >> c & 1)
            inverse_heights += length / of.scene.frame.metres_per_unit / area2;
    }
    const double height = kept == 7 ? area2 / perimeter : 1 / inverse_heights;
    return of.metres(std::min<double>(height - 2.0 * of.partition.position_error,
                                      of.partition.self_distance[face]));
}

/// Compares the partitions of one mesh in two files: of `base` as it is and of `other` as placed.
class PartitionComparison {
  public:
    PartitionComparison(const Partitioned& base, const Partitioned& other,
                        const Placement& placement)
        : base_(base), other_(other), placement_(placement),
          scale_(std::cbrt(std::abs(glm::determinant(glm::dmat3(placement.to_world))))),
          base_error_(scale_ * base.metres(base.partition.position_error)),
          other_error_(other.metres(other.partition.position_error))
    {
        for (std::uint32_t edge = 0; edge < 3 * other.partition.face_count(); ++edge)
            edge_.push_back(edge_in_base(edge));
    }

    /// What differs first but numbers of faces, edges and maps, in words; empty if nothing does.
    /// Lengths may differ by rounding.  Of the limiting radius the largest on each face is
    /// compared, because of sets of edges that give the same one any may be kept.
    std::string difference() const
    {
        for (const std::string& found :
             {map_difference(), edge_difference(), contact_difference(), length_difference()})
            if (!found.empty())
                return found;
        return {};
    }

  private:
    FaceId face(FaceId place) const { return placement_.face_at(place); }

    /// A vertex of the base's face, by what is nearest to where an edge of the other begins.
    std::uint32_t corner_in_base(std::uint32_t edge) const
    {
        std::array<double, 3> off;
        for (std::uint32_t c = 0; c < 3; ++c) {
            const glm::dvec4 corner(base_.start(3 * face(edge / 3) + c), 1.0);
            off[c] = glm::distance(glm::dvec3(placement_.to_world * corner), other_.start(edge));
        }
        return static_cast<std::uint32_t>(std::ranges::min_element(off) - off.begin());
    }
    std::uint32_t edge_in_base(std::uint32_t edge) const
    {
        const std::uint32_t a = corner_in_base(edge);
        const std::uint32_t b = corner_in_base(next_edge(edge));
        return 3 * face(edge / 3) + (b == (a + 1) % 3 ? a : b);
    }

    std::string map_difference() const
    {
        std::map<MapId, std::pair<MapId, bool>> seen; // map and winding in base, by map
        for (FaceId place = 0; place < other_.partition.face_count(); ++place) {
            const FaceId f = face(place);
            const MapId map = other_.partition.map_of_face[place];
            const bool turned = other_.partition.flipped[place] != base_.partition.flipped[f];
            const auto [there, is_turned] =
                seen.try_emplace(map, base_.partition.map_of_face[f], turned).first->second;
            if (there != base_.partition.map_of_face[f])
                return "face " + std::to_string(f) + " is in another map";
            if (map != kNone && is_turned != turned)
                return "face " + std::to_string(f) + " has another front than its map";
        }
        return base_.partition.map_count == other_.partition.map_count ? "" : "maps are joined";
    }

    std::string edge_difference() const
    {
        for (std::uint32_t edge = 0; edge < edge_.size(); ++edge) {
            const std::uint32_t opposite = other_.partition.opposite[edge];
            if (other_.partition.edge_class[edge] != base_.partition.edge_class[edge_[edge]])
                return "edge " + std::to_string(edge_[edge]) + " has another class";
            if ((opposite == kNone ? kNone : edge_[opposite]) !=
                base_.partition.opposite[edge_[edge]])
                return "edge " + std::to_string(edge_[edge]) + " has another opposite";
        }
        std::vector<std::uint32_t> bridged;
        for (const std::uint32_t edge : other_.partition.bridged_edges)
            bridged.push_back(edge_[edge]);
        std::ranges::sort(bridged);
        return bridged == base_.partition.bridged_edges ? "" : "other edges are bridged";
    }

    using Line = std::array<glm::dvec3, 2>;

    /// The contacts of the map that face `place` of the other is in, in the world of the other.
    std::vector<Line> contacts_at(FaceId place, bool in_base) const
    {
        const Partitioned& of = in_base ? base_ : other_;
        const glm::dmat4 to_other = in_base ? placement_.to_world : glm::dmat4(1.0);
        const MapId map = of.partition.map_of_face[in_base ? face(place) : place];
        std::vector<Line> lines;
        for (const MapContact& contact : of.partition.contacts)
            if (contact.map == map)
                lines.push_back({glm::dvec3(to_other * glm::dvec4(of.metres(contact.a), 1.0)),
                                 glm::dvec3(to_other * glm::dvec4(of.metres(contact.b), 1.0))});
        return lines;
    }

    /// How far lengths may be apart besides rounding: where faces graze each other, lengths grow
    /// with the tolerance, which follows the largest coordinate.
    double growth(double length) const
    {
        const auto [least, most] = std::minmax(base_error_, other_error_);
        return (1 - least / most) * length;
    }

    /// Whether all of a line lies along some of the others.  Where faces graze each other, its ends
    /// move by the rounding over the angle, so that a short one may be a point to the other
    /// partition.
    bool is_covered(const Line& line, std::span<const Line> others) const
    {
        const double length = glm::distance(line[0], line[1]);
        const double slack = 512 * other_error_ + 0.01 * length + growth(length);
        const auto is_near = [&](const glm::dvec3& p) {
            return std::ranges::any_of(others, [&](const Line& other) {
                const glm::dvec3 along = other[1] - other[0];
                const double at = glm::dot(p - other[0], along) / glm::dot(along, along);
                return glm::distance(p, other[0] + glm::clamp(at, 0.0, 1.0) * along) <= slack;
            });
        };
        for (int i = 0; i <= 8; ++i)
            if (length > 1024 * other_error_ && !is_near(glm::mix(line[0], line[1], i / 8.0)))
                return false;
        return true;
    }

    std::string contact_difference() const
    {
        const bool same_positions = placement_.to_world == glm::dmat4(1.0) &&
                                    placement_.order.empty() && !placement_.turned;
        if (same_positions && base_.partition.contacts.size() != other_.partition.contacts.size())
            return "there are more or fewer contacts";
        std::set<MapId> done; // a spoilt partition may have ids beyond its count
        for (FaceId place = 0; place < other_.partition.face_count(); ++place) {
            const MapId map = other_.partition.map_of_face[place];
            if (map == kNone || !done.insert(map).second)
                continue;
            const std::vector<Line> before = contacts_at(place, true);
            const std::vector<Line> after = contacts_at(place, false);
            for (const auto& [some, others] : {std::pair(&before, &after), {&after, &before}})
                for (const Line& line : *some)
                    if (!is_covered(line, *others))
                        return "map " + std::to_string(map) + " has a contact in one of two";
        }
        return {};
    }

    bool is_near(double in_base, double in_other) const
    {
        const double expected = scale_ * in_base;
        return expected == in_other || // both may be infinite
               std::abs(expected - in_other) <=
                   16 * other_error_ + 1e-4 * expected + growth(expected);
    }

    std::string length_difference() const
    {
        for (FaceId place = 0; place < other_.partition.face_count(); ++place) {
            const FaceId f = face(place);
            const std::string start = "face " + std::to_string(f) + " has another ";
            if (other_.partition.candidate[place] != base_.partition.candidate[f])
                return start + "candidacy";
            if (!is_near(base_.metres(base_.partition.reach[f]),
                         other_.metres(other_.partition.reach[place])))
                return start + "reach";
            if (base_.partition.map_of_face[f] != kNone &&
                !is_near(best_radius(base_, f), best_radius(other_, place)))
                return start + "limiting radius";
        }
        return {};
    }

    const Partitioned& base_;
    const Partitioned& other_;
    const Placement& placement_;
    double scale_;
    double base_error_, other_error_; ///< position errors, metres in the other's world
    std::vector<std::uint32_t> edge_; ///< [3F] of base, by that of other
};

} // namespace hipmap::tiny
