#pragma once

#include "common/partition/partition.h"
#include "common/scene/mesh.h"
#include "render/maps/boundary_segment.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace hipmap {

/// Returns the square distance to an axis-aligned box, square scene units; 0 within it.
double distance2_to_box(const glm::vec3& point, const glm::vec3& low, const glm::vec3& high);

/// The boundaries of the shared maps of stored faces, by map: the edges across which no photon is
/// gathered.
///
/// The boundary of a map is every unconnected, border and non-manifold edge of its faces.  An edge
/// with the same map on both sides counts too, listed once if both faces know of each other: the
/// surface is creased there, or something stands on it.  Edges of faces without area do not count:
/// such a face has no map, and what lies behind it is not known.  Where a surface stands on another
/// or cuts through it, the partition's contacts are boundaries too; its bridged edges are none.
/// Chains that are straight within the rounding of their points are one segment each, so that
/// subdividing a face adds none.
///
/// Read-only once built: any number of threads may query it.
class MapBoundaries {
  public:
    /// Builds the boundaries.  partition: of this very mesh.  Copies what it needs of both. Cost:
    /// O(n log n) for n segments in one map, linear in the number of maps.
    MapBoundaries(const TriangleMesh& mesh, const Partition& partition);

    /// Builds the boundaries of the maps of some contacts, by map; a map is known by its place
    /// among those that have contacts.  rounding: the partition's position error.
    MapBoundaries(std::span<const MapContact> contacts, float rounding);

    /// Returns the whole boundary of a map; empty for a closed surface.
    std::span<const BoundarySegment> of(MapId map) const;

    /// Appends the segments of `map` within `radius` of `point` to `out`, in a fixed order.
    /// radius: scene units, >= 0, may be infinite.  Returns false if there are more than `most`;
    /// `out` then holds some of them. Cost: a loop for a map of few segments, else logarithmic plus
    /// the segments found.
    bool near(MapId map, const glm::vec3& point, float radius, std::vector<BoundarySegment>& out,
              std::size_t most = std::numeric_limits<std::size_t>::max()) const;

    /// A node of a balanced tree in preorder: the left child follows its parent, and the children
    /// halve the parent's range of segments.  A range of kLeafSize segments or fewer has none.
    struct Node {
        glm::vec3 low, high;
        std::uint32_t right;
    };
    static constexpr std::uint32_t kLeafSize = 4;

    /// Returns the root of a map's tree: only for maps of more than kLeafSize segments.
    std::uint32_t root(MapId map) const { return ranges_[map].node; }
    const Node& node(std::uint32_t index) const { return nodes_[index]; }

  private:
    struct MapRange {
        std::uint32_t segment; ///< first of the map
        std::uint32_t node;    ///< root, if the map has a tree
    };

    /// for_each(visit) calls visit(map, segment) for all segments, the same twice.
    template <typename ForEach>
    void build(std::size_t map_count, float rounding, const ForEach& for_each);
    std::uint32_t build_tree(std::uint32_t begin, std::uint32_t end);
    void append_near(std::uint32_t begin, std::uint32_t end, const glm::vec3& point, double radius2,
                     std::vector<BoundarySegment>& out) const;

    std::vector<BoundarySegment> segments_; ///< map by map
    std::vector<MapRange> ranges_;          ///< [map_count + 1]
    std::vector<Node> nodes_;
};

/// The boundaries that maps of copies have with what stands about them, and maps of shared faces
/// where they are stored.  Read-only.
struct OwnBoundaries {
    std::vector<MapId> maps;  ///< ascending
    MapBoundaries boundaries; ///< by place in `maps`

    explicit OwnBoundaries(const Partition& partition);

    /// Returns the place of a map; kNone: it has none.
    MapId place(MapId map) const
    {
        const auto found = std::ranges::lower_bound(maps, map);
        return found == maps.end() || *found != map ? kNone
                                                    : static_cast<MapId>(found - maps.begin());
    }
};

} // namespace hipmap
