#pragma once

#include "common/math/bounds.h"
#include "common/partition/partition.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace hipmap {

/// A part of a surface that the image sees, docs/error.md (21).
struct SeenRegion {
    Bounds<glm::vec3> box; ///< photons outside of it do not count
    float worth = 0;       ///< what a photon there adds to the image, per power
};

/// The regions in which photons of one kind count in an image.  Each side of a shared map has a
/// tree of its own, a node before its children.  Read-only once built.
struct SeenRegions {
    struct Node {
        float split = 0;
        std::uint32_t axis = kLeaf;
        std::uint32_t next = 0; ///< the second child (the first follows), or the region of a leaf
    };
    static constexpr std::uint32_t kLeaf = 3;
    static constexpr std::uint32_t kNoRegion = std::numeric_limits<std::uint32_t>::max();

    std::vector<std::uint64_t> sides; ///< ascending, as side_of has them
    std::vector<std::uint32_t> roots; ///< [sides] into nodes
    std::vector<Node> nodes;
    std::vector<SeenRegion> regions;
    double mean_worth = 0; ///< of a photon where the image looks

    static std::uint64_t side_of(MapId map, std::uint8_t side)
    {
        return std::uint64_t{2} * map + side % 2u;
    }
    /// Returns the region of a photon on a side of a map; kNoRegion: the image does not see it.
    std::uint32_t region_at(std::uint64_t side, const glm::vec3& position) const;
};

/// The surfaces where photons count in an image.  Borrows mesh and partition.
struct SeenSurfaces {
    const TriangleMesh& mesh;
    const Partition& partition;
    SeenRegions caustic, global; ///< by the kind of photon
    double light = 0;            ///< of the image, in the unit of a photon's power times its worth
    double unit = 0;             ///< of SeenClasses::Class::worth
    std::vector<std::uint8_t> reached = {}; ///< [LightSet::lights] 1: a light sample reached them;
                                            ///<   empty: none was taken
};

} // namespace hipmap
