#pragma once

#include "render/maps/boundary_outline.h"
#include "render/maps/find_photons.h"
#include "render/maps/fold_areas.h"
#include "render/maps/visible_disc.h"

namespace hipmap {

/// Scratch memory of the estimates of one thread.
struct EstimateScratch {
    SearchScratch search;
    OutlineScratch outline;
    std::vector<BoundarySegment> segments; ///< that `disc` is looked at past
    std::vector<BoundarySegment> own;      ///< those of OwnBoundaries among them
    VisibleDisc disc;
    bool near_boundary = false; ///< the last estimate was, so that the next may need a list
};

/// The surfaces that photons lie on, with the boundaries of their maps.  Borrows mesh and
/// partition. Read-only: any number of threads may use it.
struct MapSurfaces {
    const TriangleMesh& mesh;
    const Partition& partition;
    MapBoundaries boundaries; ///< of stored faces
    OwnBoundaries own_boundaries;
    std::vector<glm::vec3> normals;     ///< [F] unit, towards side 0; zero for a face without area
    std::vector<float> map_area;        ///< [shared maps of stored faces] square scene units
    std::vector<std::uint32_t> fold_of; ///< [the same] tree of folds; kNone: no two of its
                                        ///<     faces look away from each other
    FoldTrees folds;

    MapSurfaces(const TriangleMesh& of_mesh, const Partition& of_partition);

    /// Returns the area of the map of a face, which must have one; square scene units.
    float area_at(FaceId face) const
    {
        const float area = map_area[partition.map_of_face[partition.stored_face(face)]];
        if (!mesh.is_copied(face)) [[likely]]
            return area;
        const double scale = mesh.copy_of(face).place.scale;
        return static_cast<float>(scale * scale * area);
    }
    /// Returns whether a wide disc at a face may reach faces of its map that look away from it.
    bool may_fold(FaceId face) const
    {
        const MapId map = partition.map_of_face[partition.stored_face(face)];
        return map != kNone && fold_of[map] != kNone;
    }
    /// Returns how much of a face's map, which must fold, looks to the side of the face and lies
    /// within each radius of a point on it, docs/visible_area.md (A9); square scene units.  radii:
    /// at most three.
    FoldAreas facing_areas(FaceId face, const glm::vec3& point, std::span<const float> radii,
                           AreaOf of) const;
    /// Returns the normal of any face, as `normals` has it.
    glm::vec3 normal(FaceId face) const
    {
        if (!mesh.is_copied(face)) [[likely]]
            return normals[face];
        const glm::dvec3 stored(normals[mesh.stored_face(face)]);
        return glm::vec3(mesh.copy_of(face).place.direction(stored));
    }
};

/// Returns the radius within which k photons would lie if the photons of the query's map were
/// spread evenly over it, docs/photon_maps.md (5); infinite for an empty map or a face without one.
float even_radius(const PhotonMaps& maps, const MapSurfaces& surfaces, const PhotonQuery& query);

/// Density of photon power at a point, W/m2 (power and area are both in scene units): the
/// irradiance, with what depends on the direction of arrival already in the photons' power.
///     E = 1 / A(r_k) * sum of the k-1 nearest powers                  docs/photon_maps.md (2)
/// or, where fewer than k lie within the query's radius, all of them over the area within it (over
/// the whole map if the radius is infinite), (3).  A(r) is the part of the disc that is visible
/// from the query without crossing a boundary of its map, docs/visible_area.md; photons beyond one
/// do not count.  Where a boundary is near, photons of tilted faces count by the cosine, (4). Where
/// the query names lobes, each photon is weighed by them, and it is the radiance they send back,
/// W/(m2 sr).
/// No photon: zero, never NaN.  Thread-safe.  Blurs detail finer than r_k.
Rgb estimate_irradiance(const PhotonMaps& maps, const MapSurfaces& surfaces,
                        const PhotonQuery& query, EstimateScratch& scratch);

} // namespace hipmap
