#include "experiments/rivals/face_cells.h"

#include <algorithm>
#include <cmath>

namespace hipmap {

namespace {

/// A cell by its place in the grid of a face: the triangle (i, j), (i + 1, j), (i, j + 1), or the
/// upper one, (i + 1, j), (i, j + 1), (i + 1, j + 1).
struct GridPlace {
    std::uint32_t i = 0, j = 0;
    bool upper = false;
    glm::vec3 weights{0.0f}; ///< of these corners at the point asked for
};

GridPlace place_at(std::uint32_t across, const glm::vec2& barycentric)
{
    const auto n = static_cast<float>(across);
    const auto last = static_cast<float>(across - 1);
    const glm::vec2 at = glm::clamp(barycentric, 0.0f, 1.0f) * n;
    GridPlace out;
    out.i = static_cast<std::uint32_t>(std::min(std::floor(at.x), last));
    const auto highest = static_cast<float>(across - 1 - out.i);
    out.j = static_cast<std::uint32_t>(std::min(std::floor(at.y), highest));
    const glm::vec2 in = glm::min(at - glm::vec2(out.i, out.j), 1.0f);
    out.upper = in.x + in.y > 1 && out.i + out.j + 1 < across;
    out.weights = out.upper ? glm::vec3(1 - in.y, 1 - in.x, in.x + in.y - 1)
                            : glm::vec3(std::max(0.0f, 1 - in.x - in.y), in.x, in.y);
    return out;
}

/// Cells before strip i of a face.
std::uint32_t cells_before(std::uint32_t across, std::uint32_t i)
{
    return 2 * across * i - i * i;
}

std::uint32_t point_at(std::uint32_t across, std::uint32_t i, std::uint32_t j)
{
    return i * (across + 1) - i * (i - 1) / 2 + j;
}

GridPlace place_of(std::uint32_t across, std::uint32_t cell)
{
    GridPlace out;
    while (out.i + 1 < across && cells_before(across, out.i + 1) <= cell)
        ++out.i;
    const std::uint32_t in_strip = cell - cells_before(across, out.i);
    out.j = in_strip / 2;
    out.upper = in_strip % 2 == 1;
    return out;
}

std::array<glm::uvec2, 3> corners_at(const GridPlace& at)
{
    if (at.upper)
        return {{{at.i + 1, at.j}, {at.i, at.j + 1}, {at.i + 1, at.j + 1}}};
    return {{{at.i, at.j}, {at.i + 1, at.j}, {at.i, at.j + 1}}};
}

std::size_t corner_index(const FaceCells& cells, FaceId face, const glm::uvec2& corner)
{
    return cells.first_point[face] + point_at(cells.across[face], corner.x, corner.y);
}

} // namespace

FaceCells divide_faces(const TriangleMesh& mesh, std::uint64_t cells)
{
    double area = 0;
    for (FaceId face = 0; face < mesh.face_count(); ++face)
        area += face_area(mesh, face);
    FaceCells out;
    out.first_cell = out.first_point = {0};
    for (FaceId face = 0; face < mesh.face_count(); ++face) {
        const double wanted = static_cast<double>(cells) * face_area(mesh, face) / area;
        const auto n =
            static_cast<std::uint32_t>(std::max(1.0, std::round(std::sqrt(wanted)))); // n^2 cells
        out.across.push_back(n);
        out.first_cell.push_back(out.first_cell.back() + n * n);
        out.first_point.push_back(out.first_point.back() + (n + 1) * (n + 2) / 2);
        out.face_of_cell.insert(out.face_of_cell.end(), std::size_t{n} * n, face);
    }
    return out;
}

std::uint32_t cell_at(const FaceCells& cells, FaceId face, const glm::vec2& barycentric)
{
    const GridPlace at = place_at(cells.across[face], barycentric);
    return cells.first_cell[face] + cells_before(cells.across[face], at.i) + 2 * at.j + at.upper;
}

std::array<glm::vec2, 3> corners_of(const FaceCells& cells, std::uint32_t cell)
{
    const FaceId face = cells.face_of_cell[cell];
    const auto n = static_cast<float>(cells.across[face]);
    std::array<glm::vec2, 3> out;
    const auto corners = corners_at(place_of(cells.across[face], cell - cells.first_cell[face]));
    for (std::size_t c = 0; c < 3; ++c)
        out[c] = glm::vec2(corners[c]) / n;
    return out;
}

glm::vec2 barycentric_of(const TriangleMesh& mesh, FaceId face, const glm::vec3& position)
{
    const std::array<glm::vec3, 3> corners = mesh.triangle(face);
    const glm::vec3 a = corners[1] - corners[0], b = corners[2] - corners[0];
    const glm::vec3 normal = glm::cross(a, b), to = position - corners[0];
    const float area2 = glm::dot(normal, normal);
    return {glm::dot(glm::cross(to, b), normal) / area2,
            glm::dot(glm::cross(a, to), normal) / area2};
}

std::vector<Rgb> values_of_corners(const FaceCells& cells, const std::vector<Rgb>& of_cells)
{
    std::vector<Rgb> out(2 * std::size_t{cells.first_point.back()}, Rgb(0));
    std::vector<float> around(cells.first_point.back(), 0.0f);
    for (std::uint32_t cell = 0; cell < cells.count(); ++cell) {
        const FaceId face = cells.face_of_cell[cell];
        const GridPlace at = place_of(cells.across[face], cell - cells.first_cell[face]);
        for (const glm::uvec2& corner : corners_at(at)) {
            const std::size_t index = corner_index(cells, face, corner);
            out[2 * index] += of_cells[2 * std::size_t{cell}];
            out[2 * index + 1] += of_cells[2 * std::size_t{cell} + 1];
            ++around[index];
        }
    }
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i] /= around[i / 2];
    return out;
}

Rgb smooth_value(const FaceCells& cells, const std::vector<Rgb>& of_corners, const RayHit& hit,
                 std::uint8_t side)
{
    const GridPlace at = place_at(cells.across[hit.face], hit.barycentric);
    const std::array<glm::uvec2, 3> corners = corners_at(at);
    Rgb sum(0.0f);
    for (int c = 0; c < 3; ++c)
        sum += at.weights[c] *
               of_corners[2 * corner_index(cells, hit.face, corners[static_cast<std::size_t>(c)]) +
                          side];
    return sum;
}

} // namespace hipmap
