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

/// Places the densities: one for the inside of each material, in the box of the closed meshes that
/// have it, and last that of the surrounding medium, in the box of all faces.  [M + 1].
std::vector<PlacedDensity> place_densities(const Scene& scene, const Partition& partition);

/// Returns the integral of the density over the part of a ray from near to far, which must be
/// finite; where the density is 1 this is the length.  Scene units.  Cost: linear in the cells that
/// it crosses.
float total_optical_depth(const PlacedDensity& density, const Ray& part);

/// The integral of the density along a ray, as a function of distance: the optical depth for an
/// extinction of 1.
struct OpticalDepth {
    /// The part of the integral within one cell of the grid.
    struct Piece {
        glm::uvec3 cell;
        double near = 0, far = 0;   ///< along the ray
        double before = 0, own = 0; ///< optical depth before the piece and in it
    };
    const PlacedDensity* density = nullptr;
    Ray part;
    std::vector<Piece> pieces; ///< of a grid; each begins where the last one ends
    float total = 0;
};

/// Computes the optical depth along a part of a ray.  Borrows the density.
OpticalDepth optical_depth_along(const PlacedDensity& density, const Ray& part);

/// Returns the optical depth from the near end to this distance along the ray.  Cost: logarithmic
/// in the pieces.
float optical_depth_to(const OpticalDepth& optical_depth, float distance);

/// Returns the distance along the ray at which the optical depth reaches `size`; the far end if it
/// never does.
float distance_at(const OpticalDepth& optical_depth, float size);

} // namespace hipmap
