#pragma once

#include "common/partition/partition.h"
#include "common/rays/embree_scene.h"
#include "common/scene/scene.h"

#include <vector>

namespace hipmap {

/// The density of a medium, docs/media.md (11).  Borrows the grid.
struct PlacedDensity {
    const DensityGrid* grid = nullptr; ///< null: 1 everywhere
    glm::vec3 low{0.0f};               ///< of the box that it fills, scene units
    glm::vec3 cells_per_unit{0.0f};    ///< zero along axes of which the box has no length
};

/// Of the insides of all materials, each in the box of the closed meshes that wear it, and last of
/// what is around, in the box of all faces.  [M + 1].
std::vector<PlacedDensity> place_densities(const Scene& scene, const Partition& partition);

/// Integral of the density over the part of a ray from near to far, which is finite: the length
/// where the density is 1.  Scene units.  Cost: linear in the cells that it crosses.
float total_optical_depth(const PlacedDensity& density, const Ray& part);

/// That integral as a function of the distance along the ray.
struct OpticalDepth {
    /// Within one cell of the grid.
    struct Piece {
        glm::uvec3 cell;
        double near = 0, far = 0;   ///< along the ray
        double before = 0, own = 0; ///< of the optical_depth
    };
    const PlacedDensity* density = nullptr;
    Ray part;
    std::vector<Piece> pieces; ///< of a grid; each begins where the last one ends
    float total = 0;
};

/// Borrows the density.
OpticalDepth optical_depth_along(const PlacedDensity& density, const Ray& part);

/// From the near end to this distance along the ray.  Cost: logarithmic in the pieces.
float optical_depth_to(const OpticalDepth& optical_depth, float distance);

/// The distance along the ray at which the optical_depth is so large; beyond all of it the far end.
float distance_at(const OpticalDepth& optical_depth, float size);

} // namespace hipmap
