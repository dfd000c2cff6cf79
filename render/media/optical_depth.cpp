#include "render/media/optical_depth.h"

#include "common/math/bounds.h"
#include "common/scene/store_copies.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hipmap {

namespace {

constexpr int kMostSteps = 64; ///< of a search within a cell

/// A ray in units of cells.
struct GridRay {
    glm::dvec3 origin, direction;

    GridRay(const PlacedDensity& density, const Ray& ray)
        : origin((glm::dvec3(ray.origin) - glm::dvec3(density.low)) *
                 glm::dvec3(density.cells_per_unit)),
          direction(glm::dvec3(ray.direction) * glm::dvec3(density.cells_per_unit))
    {
    }
    glm::dvec3 at(double distance) const { return origin + distance * direction; }
};

double density_at(const DensityGrid& grid, const glm::uvec3& cell, const glm::dvec3& at)
{
    const glm::dvec3 f = glm::clamp(at - glm::dvec3(cell), 0.0, 1.0);
    const std::size_t line = grid.nodes.x, layer = line * grid.nodes.y;
    const float* corner = grid.values.data() + cell.x + cell.y * line + cell.z * layer;
    const auto along_x = [&](std::size_t i) {
        return corner[i] + f.x * (corner[i + 1] - corner[i]);
    };
    const auto across = [&](std::size_t i) {
        const double low = along_x(i);
        return low + f.y * (along_x(i + line) - low);
    };
    const double low = across(0);
    return low + f.z * (across(layer) - low);
}

/// Integral over a part of a cell.  The density is a polynomial of third order there, for which
/// Simpson's rule is exact.
double integral(const DensityGrid& grid, const GridRay& ray, const glm::uvec3& cell, double near,
                double far)
{
    const auto value = [&](double at) { return density_at(grid, cell, ray.at(at)); };
    return (far - near) / 6 * (value(near) + 4 * value((near + far) / 2) + value(far));
}

/// The part of a ray that lies in the box; empty: near >= far.
std::array<double, 2> within_box(const DensityGrid& grid, const GridRay& ray, const Ray& part)
{
    double near = part.near, far = part.far;
    for (int axis = 0; axis < 3; ++axis) {
        const double size = grid.nodes[axis] - 1;
        if (ray.direction[axis] == 0) {
            if (ray.origin[axis] < 0 || ray.origin[axis] > size)
                return {0, 0};
            continue;
        }
        const double a = -ray.origin[axis] / ray.direction[axis];
        const double b = (size - ray.origin[axis]) / ray.direction[axis];
        near = std::max(near, std::min(a, b));
        far = std::min(far, std::max(a, b));
    }
    return {near, far};
}

/// Calls `visit(cell, near, far)` for the cells of the grid that the part crosses, in order.
template <typename Visit>
void for_each_cell(const DensityGrid& grid, const GridRay& ray, const Ray& part, const Visit& visit)
{
    auto [near, far] = within_box(grid, ray, part);
    if (!(near < far))
        return;
    const glm::dvec3 last = glm::dvec3(grid.nodes) - 2.0;
    glm::uvec3 cell(glm::clamp(glm::floor(ray.at(near)), glm::dvec3(0), last));
    // Each turn leaves a cell for good, so that there are no more turns than layers of cells.
    for (;;) {
        int axis = -1;
        double next = far;
        for (int i = 0; i < 3; ++i) {
            if (ray.direction[i] == 0)
                continue;
            const double side = cell[i] + (ray.direction[i] > 0 ? 1.0 : 0.0);
            const double crossed = (side - ray.origin[i]) / ray.direction[i];
            if (crossed < next) {
                next = crossed;
                axis = i;
            }
        }
        if (next > near)
            visit(cell, near, next);
        near = std::max(near, next);
        if (axis < 0 || (ray.direction[axis] < 0 ? cell[axis] == 0 : cell[axis] >= last[axis]))
            return;
        cell[axis] += ray.direction[axis] > 0 ? 1 : -1;
    }
}

PlacedDensity place(const DensityGrid* grid, const Bounds<glm::vec3>& box)
{
    PlacedDensity out;
    if (grid == nullptr || box.empty())
        return out;
    out.grid = grid;
    out.low = box.low;
    for (int axis = 0; axis < 3; ++axis) {
        const float length = box.high[axis] - box.low[axis];
        out.cells_per_unit[axis] =
            length > 0 ? static_cast<float>(grid->nodes[axis] - 1) / length : 0.0f;
    }
    return out;
}

} // namespace

std::vector<PlacedDensity> place_densities(const Scene& scene, const Partition& partition)
{
    std::vector<Bounds<glm::vec3>> boxes(scene.materials.size() + 1);
    boxes.back() = bounds_of(scene.mesh);
    for (FaceId face = 0; face < scene.mesh.face_count(); ++face)
        if (partition.is_closed(face)) // no copies have media
            for (const glm::vec3& corner : scene.mesh.triangle(face))
                boxes[scene.mesh.material_of(face)].add(corner);
    std::vector<PlacedDensity> out;
    for (std::size_t m = 0; m < scene.materials.size(); ++m)
        out.push_back(place(scene.materials[m].density.get(), boxes[m]));
    out.push_back(place(scene.around.density.get(), boxes.back()));
    return out;
}

float total_optical_depth(const PlacedDensity& density, const Ray& part)
{
    if (density.grid == nullptr)
        return part.far - part.near;
    double sum = 0;
    const GridRay ray(density, part);
    for_each_cell(*density.grid, ray, part, [&](const glm::uvec3& cell, double near, double far) {
        sum += integral(*density.grid, ray, cell, near, far);
    });
    return static_cast<float>(sum);
}

OpticalDepth optical_depth_along(const PlacedDensity& density, const Ray& part)
{
    OpticalDepth out{&density, part, {}, part.far - part.near};
    if (density.grid == nullptr)
        return out;
    double sum = 0;
    const GridRay ray(density, part);
    for_each_cell(*density.grid, ray, part, [&](const glm::uvec3& cell, double near, double far) {
        const double own = integral(*density.grid, ray, cell, near, far);
        out.pieces.push_back({cell, near, far, sum, own});
        sum += own;
    });
    out.total = static_cast<float>(sum);
    return out;
}

float optical_depth_to(const OpticalDepth& optical_depth, float distance)
{
    if (optical_depth.density->grid == nullptr)
        return distance - optical_depth.part.near;
    const auto after = std::upper_bound(
        optical_depth.pieces.begin(), optical_depth.pieces.end(), distance,
        [](float value, const OpticalDepth::Piece& piece) { return value < piece.near; });
    if (after == optical_depth.pieces.begin())
        return 0;
    const OpticalDepth::Piece& piece = *(after - 1);
    if (distance >= piece.far)
        return static_cast<float>(piece.before + piece.own);
    return static_cast<float>(piece.before +
                              integral(*optical_depth.density->grid,
                                       GridRay(*optical_depth.density, optical_depth.part),
                                       piece.cell, piece.near, distance));
}

float distance_at(const OpticalDepth& optical_depth, float size)
{
    if (optical_depth.density->grid == nullptr)
        return optical_depth.part.near + size;
    const auto after = std::upper_bound(optical_depth.pieces.begin(), optical_depth.pieces.end(),
                                        size, [](float value, const OpticalDepth::Piece& piece) {
                                            return value < piece.before + piece.own;
                                        });
    if (after == optical_depth.pieces.end())
        return optical_depth.part.far;
    const OpticalDepth::Piece& piece = *after;
    const GridRay ray(*optical_depth.density, optical_depth.part);
    double low = piece.near, high = piece.far;
    const double wanted = size - piece.before;
    double guess = low + (high - low) * (wanted / piece.own);
    for (int step = 0; step < kMostSteps && low < guess && guess < high; ++step) {
        const double off =
            integral(*optical_depth.density->grid, ray, piece.cell, piece.near, guess) - wanted;
        (off > 0 ? high : low) = guess;
        const double slope = density_at(*optical_depth.density->grid, piece.cell, ray.at(guess));
        if (std::abs(off) <= 1e-7 * piece.own)
            break;
        const double newton = guess - off / slope;
        guess = newton > low && newton < high ? newton : (low + high) / 2;
    }
    return static_cast<float>(guess);
}

} // namespace hipmap
