#pragma once

#include "render/dissertation/dissertation_maps.h"

namespace hipmap {

/// Plans the local and the group level of mode hierarchical from the shared maps' wide trees,
/// docs/photon_maps.md (8), and keeps the maps of the levels that are used.  Same maps, same plan,
/// at any thread count.  Cost: a pass over the photons, and searches for some 1000 of them.  No
/// photons: no levels.
void build_levels(DissertationMaps& maps, const MapSurfaces& surfaces);

/// Builds maps of faces, and in mode hierarchical of groups, by reference into the shared maps: the
/// thesis' local maps, and the levels of mode hierarchical on kd-trees, no part of which is a tree
/// for them.  slot_of: [photons] in their shared maps.  Same photons, same maps, at any thread
/// count.
void build_local_maps(DissertationMaps& maps, const std::vector<Photon>& photons,
                      const std::vector<std::uint32_t>& slot_of, const MapSurfaces& surfaces);

} // namespace hipmap
