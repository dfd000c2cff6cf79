#pragma once

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace hipmap {

/// Cuts a polygon into corners.size() - 2 triangles of positions in `points`, always that many:
/// where the polygon crosses itself or has no area, some overlap or are degenerate. points: in
/// order round the polygon, three or more, nearly planar.  A convex polygon becomes a fan, in
/// linear time; others are cut ear by ear, in quadratic time at best. Source: Meisters 1975,
/// "Polygons have ears".
std::vector<glm::uvec3> triangulate(std::span<const glm::dvec3> points);

} // namespace hipmap
