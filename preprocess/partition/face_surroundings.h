#pragma once

#include "preprocess/partition/face_tree.h"
#include "preprocess/partition/nearby_faces.h"
#include "preprocess/partition/share_maps.h"

namespace hipmap {

/// What the clearances of faces are found in.
struct MapTree {
    const TriangleMesh& mesh;
    std::span<const MapId> map_of_face;
    const FaceTree& tree;
    std::vector<MapId> map_of_node; ///< by FaceTree::Range::node; kNone: of several maps
    std::vector<std::uint32_t> faces_of_map;

    /// Whether a node has no face of a map.
    bool lacks(MapId map, const FaceTree::Range& range) const
    {
        return map_of_node[range.node] != map && map_of_node[range.node] != kNone;
    }
};

/// A face with the planes through its edges, among the faces of its shared map.
class FaceSurroundings {
  public:
    FaceSurroundings(const MapTree& maps, FaceId face, double error);

    const std::array<EdgePlane, 3>& planes() const { return planes_; }

    /// Largest height over the nearest of the chosen planes, of any point of the face.
    double largest_height(unsigned edges) const;

    /// Distance of the face from the map's other faces in front of the chosen planes; infinity if
    /// it is not below `bound`, 0 if finding it takes too long.
    double distance_in_front(unsigned edges, double bound) const;

    /// The same among faces that were sorted out by this face's planes, and hold all of the map
    /// within `bound`.
    double distance_in_front(unsigned edges, const NearbyFaces& nearby, double bound) const;

  private:
    bool behind(unsigned edges, const Bounds<glm::vec3>& box) const;
    double distance_of(unsigned edges, FaceId other) const;

    const MapTree& maps_;
    FaceId face_;
    MapId map_;
    double error_;
    std::array<glm::dvec3, 3> corners_;
    std::array<EdgePlane, 3> planes_;
};

} // namespace hipmap
