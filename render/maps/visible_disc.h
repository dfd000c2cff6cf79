#pragma once

#include "render/maps/map_boundaries.h"
#include "render/maps/own_fold.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

namespace hipmap {

/// The point and the radius of a disc in which photons are gathered.
struct DiscQuery {
    std::array<glm::vec3, 3> face; ///< corners of the face the point lies on
    glm::vec3 point;               ///< on the face up to rounding, beyond its edges too
    float radius;                  ///< the largest that will be asked about; > 0, finite
};

/// A boundary segment in the plane of a query, counter-clockwise about the query, which is the
/// origin.
struct DiscWall {
    glm::dvec2 a, b;
    double cross; ///< a x b > 0
};

/// What decides whether photons are seen past few walls.  Borrows what it names.
struct DiscView {
    const glm::dvec3 &centre, &x_axis, &y_axis, &normal; ///< the query and its plane
    OwnFold fold;
    double nearest2; ///< of any wall, squared; infinite: there is none
    std::span<const DiscWall> walls;
};

/// The part of a disc around a point that is visible from the point within the boundary of its map:
/// docs/visible_area.md.  Everything is projected along the normal of the query's face into its
/// plane; where the map is planar, that is exact.
///
/// An object keeps its memory between queries and serves one thread.  Const functions are
/// thread-safe.
class VisibleDisc {
  public:
    /// Computes what is visible from `query.point`.  boundary: at least the segments of the map
    /// within the radius, in any order.  Without any, and from a face without area, everything is.
    /// Cost: nothing without segments, else O(n log n).
    void look(const DiscQuery& query, std::span<const BoundarySegment> boundary)
    {
        walls_.clear();
        everything_ = boundary.empty() || !look_past(query, boundary);
    }

    /// Returns whether nothing hides any of the disc.
    bool whole() const { return walls_.empty(); }

    /// Returns whether the straight segment from the query to `photon` crosses no boundary (A1),
    /// and the photon is on the query's own fold (A7). photon: within the radius.  Cost:
    /// logarithmic in the segments.
    bool sees(const glm::vec3& photon) const { return everything_ || sees_past_walls(photon); }

    /// Returns whether it sees all photons.
    bool sees_everything() const { return everything_; }

    /// Returns the walls that it looks past, if they are few; it must not see everything.
    std::optional<DiscView> few_walls() const;

    /// Returns the area of the visible part of the disc of radius r, square scene units (A4). r: >
    /// 0, at most the query's radius.  Never more than pi r^2; never zero (A5). Cost: linear in the
    /// segments.
    double area(float r) const
    {
        return whole() ? std::numbers::pi * (double(r) * r) : area_within_walls(r);
    }

  private:
    /// A point of a wall and the key of its direction.
    struct Mark {
        glm::dvec2 point;
        double key;
    };
    /// The part of a wall that is nearest to the query.
    struct Piece {
        Mark from, to;
        std::uint32_t wall;
    };
    struct Chord {
        Mark from, to;
        double area2; ///< twice the area of the triangle it makes with the query
    };

    bool look_past(const DiscQuery& query, std::span<const BoundarySegment> boundary);
    bool set_plane(const DiscQuery& query);
    PlanePoint project(const glm::vec3& point) const;
    void add_walls(const BoundarySegment& segment, double radius2);
    void add_wall(glm::dvec2 a, glm::dvec2 b, double radius2);
    void build_envelope();
    void add_first_pieces(std::uint32_t wall);
    void merge(std::span<const Piece> left, std::span<const Piece> right);
    void emit_nearer(const Piece& left, const Piece& right);
    void emit(const Piece& piece);
    Mark mark_towards(const Piece& piece, const Mark& direction) const;
    bool clip(const Piece& piece, double r2, Chord& chord) const;
    static bool hides(const DiscWall& wall, const glm::dvec2& p);
    bool sees_past_walls(const glm::vec3& photon) const;
    double area_within_walls(float r) const;

    bool everything_ = true; ///< is seen: nothing was looked past
    OwnFold fold_{0};
    glm::dvec3 centre_{0.0}, x_axis_{0.0}, y_axis_{0.0}, normal_{0.0};
    double nearest2_ = std::numeric_limits<double>::infinity(); ///< of any wall, squared
    std::vector<DiscWall> walls_;
    std::vector<Piece> envelope_; ///< by direction, disjoint
    std::vector<DiscWall> few_;   ///< those of the envelope, if it has few pieces
    std::vector<Piece> merged_;   ///< scratch, as are the two below
    std::vector<std::uint32_t> runs_, merged_runs_;
};

} // namespace hipmap
