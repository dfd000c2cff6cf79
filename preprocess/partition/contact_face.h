#pragma once

#include "common/partition/limiting_radius.h"

#include <array>
#include <optional>

namespace hipmap {

/// A part of a segment, from 0 at its beginning to 1 at its end.
struct Interval {
    double begin = 0.0;
    double end = 1.0;
};

/// A straight piece of contact, scene units.
struct ContactLine {
    glm::dvec3 a{0.0};
    glm::dvec3 b{0.0};
};

/// A face as contacts see it: exact in double, and as thick as its positions are uncertain.
struct ContactFace {
    std::array<glm::dvec3, 3> corners;
    glm::dvec3 normal{0.0};    ///< unit
    double least_height = 0.0; ///< over the longest edge
    std::array<EdgePlane, 3> planes;
    double error = 0.0; ///< how far apart points may be that are meant to be one

    /// Prepares a face.  error: scene units, above 0.  The face's area must not be zero.
    ContactFace(const TriangleMesh& mesh, FaceId face, double error);

    /// Returns the length below which contacts count as points, scene units.
    double least_length() const { return 64 * error; }
    /// Returns whether the face is too thin for its plane to mean anything.
    bool too_thin() const { return least_height < 16 * error; }
    double height(const glm::dvec3& point) const { return glm::dot(point - corners[0], normal); }

    /// Returns the part of a segment that lies on the face: within two errors of its plane and of
    /// one of its edges.  Empty if it is shorter than least_length().
    std::optional<Interval> part_on(const glm::dvec3& a, const glm::dvec3& b) const;
};

/// Returns whether two faces lie in parallel planes, up to rounding.
bool parallel(const ContactFace& f, const ContactFace& g);

/// Returns the segment in which two faces cut through each other, each with a corner clearly on
/// both sides of the other.  Empty if they do not, or if it is shorter than their least_length().
/// Moeller 1997, "A fast triangle-triangle intersection test".
std::optional<ContactLine> crossing(const ContactFace& f, const ContactFace& g);

} // namespace hipmap
