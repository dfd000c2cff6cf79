#pragma once

#include "preprocess/partition/map_trees.h"
#include "preprocess/partition/nearby_faces.h"

namespace hipmap {

/// A face with the planes through its edges, among the faces of its shared map.
class FaceSurroundings {
  public:
    FaceSurroundings(const MapTree& map, FaceId face, double error);

    const std::array<EdgePlane, 3>& planes() const { return planes_; }

    /// Returns the largest height of any point of the face over the nearest of the chosen planes.
    double largest_height(unsigned edges) const;

    /// Returns the distance of the face from the map's other faces in front of the chosen planes;
    /// infinity if it is not below `bound`, 0 if finding it takes too long.
    double distance_in_front(unsigned edges, double bound) const;

    /// Returns the distance of the face from the map's other faces in front of the chosen planes,
    /// searching only `nearby`: faces already sorted by this face's planes that include all of the
    /// map within `bound`.
    double distance_in_front(unsigned edges, const NearbyFaces& nearby, double bound) const;

  private:
    bool behind(unsigned edges, const Bounds<glm::vec3>& box) const;
    double distance_of(unsigned edges, FaceId other) const;

    MapTree map_;
    FaceId face_;
    double error_;
    std::array<glm::dvec3, 3> corners_;
    std::array<EdgePlane, 3> planes_;
};

} // namespace hipmap
