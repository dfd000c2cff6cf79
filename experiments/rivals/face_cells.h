#pragma once

#include "common/math/rgb.h"
#include "render/shading/render_scene.h"

#include <array>
#include <vector>

namespace hipmap {

/// The faces of a mesh, each divided into n^2 triangles of one shape, its cells.  Cells have two
/// sides (Interaction::side): values of cells are indexed by 2 cell + side.
struct FaceCells {
    std::vector<std::uint32_t> across;      ///< [F] n, at least 1
    std::vector<std::uint32_t> first_cell;  ///< [F + 1]
    std::vector<std::uint32_t> first_point; ///< [F + 1] of the grid of (n + 1)(n + 2)/2 corners
    std::vector<FaceId> face_of_cell;       ///< [cells]

    std::size_t count() const { return face_of_cell.size(); }
};

/// Divides the faces so that cells have about the same area and are about so many.  At least one
/// cell a face.  The mesh has no copies.
FaceCells divide_faces(const TriangleMesh& mesh, std::uint64_t cells);

/// Returns the cell at a point of a face.
std::uint32_t cell_at(const FaceCells& cells, FaceId face, const glm::vec2& barycentric);

/// Returns the corners of a cell, as barycentric coordinates of its face.
std::array<glm::vec2, 3> corners_of(const FaceCells& cells, std::uint32_t cell);

/// Returns the barycentric coordinates of a point of a face.
glm::vec2 barycentric_of(const TriangleMesh& mesh, FaceId face, const glm::vec3& position);

/// Returns the mean of the cells around each corner of the grids of both sides, for `smooth_value`.
/// of_cells: [2 cells]. Faces do not share corners.
std::vector<Rgb> values_of_corners(const FaceCells& cells, const std::vector<Rgb>& of_cells);

/// Interpolates between the corners of a cell (Gouraud).  of_corners: by `values_of_corners`.
Rgb smooth_value(const FaceCells& cells, const std::vector<Rgb>& of_corners, const RayHit& hit,
                 std::uint8_t side);

} // namespace hipmap
