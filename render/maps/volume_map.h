#pragma once

#include "render/maps/wide_tree.h"
#include "render/media/media_set.h"
#include "render/photons/volume_photon.h"

#include <array>

namespace hipmap {

/// A radius at every point in media that follows the density of a pilot's photons, docs/media.md
/// (9). Read-only once built: any number of threads may use it.
struct VolumeRadii {
    WideTree tree;             ///< of some of them
    std::vector<float> radius; ///< [n] by slot: where the k-th of all from there is
    float widest = 0.0f;       ///< where there are fewer
};

/// Computes the radii.  neighbours: k, at least 1.  widest: scene units, above zero.  In parallel;
/// same photons, same radii.
VolumeRadii find_volume_radii(const std::vector<VolumePhoton>& pilot, std::uint32_t neighbours,
                              float widest);

/// Returns the radius at a position, scene units, above zero.  Thread-safe.
float volume_radius_at(const VolumeRadii& radii, const glm::vec3& position);

/// Photons in media, each a disc that faces every ray, under a binary tree of boxes. Read-only once
/// built: any number of threads may use it.
struct VolumeMap {
    struct Node {
        glm::vec3 low{0.0f}, high{0.0f}; ///< of the discs below
        std::uint32_t first = 0;         ///< photon, of a leaf
        std::uint32_t count = 0;         ///< of a leaf; 0: its children are the next node and ...
        std::uint32_t right = 0;         ///< ... this one
    };
    std::vector<VolumePhoton> photons; ///< in the order of the tree
    std::vector<float> radii;          ///< [n] of their discs, scene units
    std::vector<glm::vec3> walls;      ///< [n] from the photon to the nearest face within its
                                       ///<   radius; zero: none
    std::vector<Node> nodes;           ///< the root first; empty: no photon
};

/// Builds a volume map.  shrink: of the radii, relative to the first pass.  rays: of the faces at
/// which media end.  O(n log n).  Same photons in the same order, same map.
VolumeMap build_volume_map(const std::vector<VolumePhoton>& photons, const VolumeRadii& first,
                           float shrink, const EmbreeScene& rays);

/// Radii evaluated together, relative to those of the map: the first is 1, none is larger.
using BeamScales = std::array<float, 3>;

/// A part of a ray in one medium.  Borrows what it names.
struct Beam {
    const Medium& medium;
    MaterialId inside; ///< kNone: around
    const OpticalDepth& optical_depth;
};

/// Returns the radiance that photons in the medium of a beam scatter back along it, attenuated on
/// the way to its near end, for each of the scales, docs/media.md (8).  Thread-safe; the sum is
/// formed in the same order for the same map and beam.
std::array<Rgb, 3> beam_radiance(const VolumeMap& map, const Beam& beam, const BeamScales& scales);

} // namespace hipmap
