#include "experiments/rivals/face_cells.h"
#include "tests/support/tiny_scenes.h"

#include <catch2/catch.hpp>

using namespace hipmap;

TEST_CASE("face cells: the middle of each cell lies in that cell", "[rivals]")
{
    const FaceCells cells = divide_faces(tiny::cube(), 500);
    CHECK(cells.count() > 400);
    for (std::uint32_t cell = 0; cell < cells.count(); ++cell) {
        const auto corners = corners_of(cells, cell);
        const glm::vec2 middle = (corners[0] + corners[1] + corners[2]) / 3.0f;
        REQUIRE(cell_at(cells, cells.face_of_cell[cell], middle) == cell);
    }
}

TEST_CASE("face cells: points of a face have the barycentric coordinates that made them",
          "[rivals]")
{
    const TriangleMesh mesh = tiny::cube();
    const glm::vec2 made(0.2f, 0.5f);
    for (FaceId face = 0; face < mesh.face_count(); ++face) {
        const glm::vec2 found =
            barycentric_of(mesh, face, surface_point(mesh, face, made).position);
        CHECK(glm::length(found - made) < 1e-5f);
    }
}

TEST_CASE("face cells: values that are linear over a face stay so between inner corners",
          "[rivals]")
{
    const TriangleMesh mesh = tiny::floor_at(0, 1);
    const FaceCells cells = divide_faces(mesh, 2 * 64 * 64);
    std::vector<Rgb> values(2 * cells.count());
    for (std::uint32_t cell = 0; cell < cells.count(); ++cell) {
        const auto corners = corners_of(cells, cell);
        const glm::vec2 middle = (corners[0] + corners[1] + corners[2]) / 3.0f;
        values[2 * cell] = Rgb(middle.x + 2 * middle.y);
    }
    const std::vector<Rgb> corners = values_of_corners(cells, values);
    const RayHit hit{1, 0, {0.313f, 0.402f}};
    CHECK(smooth_value(cells, corners, hit, 0).x == Approx(0.313f + 2 * 0.402f).margin(1e-4));
    CHECK(is_black(smooth_value(cells, corners, hit, 1)));
}
