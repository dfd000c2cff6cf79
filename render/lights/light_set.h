#pragma once

#include "render/lights/light.h"
#include "render/lights/light_tree.h"

#include <cstdint>
#include <vector>

namespace hipmap {

/// All lights of a scene, and the subsets that each query looks at, as indices into `lights`.
/// Borrows what its lights borrow.  Read-only: any number of threads may use it.
struct LightSet {
    std::vector<Light> lights; ///< all, also those that emit nothing
    EmissiveMesh faces; ///< of all emissive meshes: direct light samples one point of all of them
    std::vector<std::uint32_t> sampled;      ///< analytic lights that direct light samples each
    std::vector<std::uint32_t> chosen;       ///< analytic lights, if many, of which `tree` chooses
    LightTree tree;                          ///< over `chosen`
    std::vector<std::uint32_t> met;          ///< lights of `sampled` that rays can meet
    bool chosen_are_met = false;             ///< rays can run into some of `chosen`
    std::vector<std::uint32_t> environments; ///< seen by rays that leave the scene
};

/// Sorts lights by how they are found.  Up to 16 analytic lights are all sampled; with more, a tree
/// chooses among those that have bounds.  faces: of all emissive meshes.
LightSet make_light_set(std::vector<Light> lights, EmissiveMesh faces);

/// Returns whether rays from surfaces can meet some analytic light.
inline bool has_met_lights(const LightSet& lights)
{
    return !lights.met.empty() || lights.chosen_are_met;
}

/// Returns whether only emissive meshes and media emit light.
inline bool has_faces_only(const LightSet& lights)
{
    return lights.sampled.empty() && lights.chosen.empty() && lights.environments.empty();
}

/// Returns whether a ray may meet some light.
bool can_be_met(const LightSet& lights);

} // namespace hipmap
