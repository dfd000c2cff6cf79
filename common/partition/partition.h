#pragma once

#include "common/scene/fingerprint.h"
#include "common/scene/mesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace hipmap {

using MapId = std::uint32_t;

/// The class of an edge of a face; see docs/partition_file.md.
enum class EdgeClass : std::uint8_t {
    connected = 0,    ///< both faces belong to one shared map
    unconnected = 1,  ///< a crease: the faces meet at the angle threshold or above
    border = 2,       ///< no face beyond
    non_manifold = 3, ///< three or more faces, or a neighbour that cannot be wound alike
    degenerate = 4,   ///< an edge of a face without area
};

/// A piece of a map's boundary that is not an edge of the map, scene units.
struct MapContact {
    MapId map = kNone;
    glm::vec3 a{0.0f}, b{0.0f};

    bool operator==(const MapContact&) const = default;
};

/// Shared faces (TriangleMesh::shared) and their maps, which have no other faces.
struct SharedPart {
    FaceId first_face = 0;
    std::uint32_t face_count = 0;
    MapId first_map = 0;
    std::uint32_t map_count = 0;

    bool operator==(const SharedPart&) const = default;
};

/// Says which faces may share photons; made by preprocess, read by render.  All arrays are by
/// stored face of the scene whose fingerprint it holds.  An edge of face f is numbered 3 f + c and
/// runs from corner c to corner (c + 1) mod 3.  Copies of shared faces have maps of their own,
/// which follow the stored ones copy by copy; functions take any face or map.
struct Partition {
    Fingerprint scene;
    double angle_threshold = 0.0;      ///< radians
    std::uint32_t map_count = 0;       ///< shared maps of stored faces: ids 0..map_count-1 by
                                       ///<     lowest face
    std::vector<MapId> map_of_face;    ///< [F]; kNone for a degenerate face
    std::vector<EdgeClass> edge_class; ///< [3F]
    std::vector<std::uint32_t>
        opposite; ///< [3F] the same edge in the face beyond; kNone if no one face
    std::vector<std::uint8_t> flipped; ///< [F] 1: wound against the rest of its map, so its
                                       ///<     front is the map's back
    std::vector<std::uint8_t>
        closed; ///< [F] 1: its connected surface has no border and encloses a volume
    std::vector<float>
        reach; ///< [F] the largest limiting radius of any point of the face,
               ///<     scene units; infinity where no edge is connected, 0 if degenerate
    std::vector<std::uint8_t> candidate; ///< [F] 1: worth a local map
    std::vector<std::uint8_t>
        kept_edges; ///< [F] bit c: the plane through edge c bounds the exact limiting radius
    std::vector<float>
        self_distance; ///< [F] what else bounds it, scene units; infinity: nothing, 0 if
                       ///<     degenerate; see exact_limiting_radius
    std::uint32_t group_count = 0;            ///< ids 0..group_count-1 by lowest face
    std::vector<std::uint32_t> group_of_face; ///< [F] patch worth a group map; kNone if there is
                                              ///<     none
    std::vector<float> group_radius; ///< [F] how near the face's centre its map comes outside the
                                     ///<     group, scene units, 0 without group; see
                                     ///<     exact_group_radius
    std::vector<std::uint32_t> bridged_edges; ///< ascending; border and non-manifold edges beyond
                                              ///<     which their map goes on: no boundary
    std::vector<MapContact> contacts;         ///< by map; boundaries where no edge is, of shared
                                              ///<     faces those that all their copies have
    float position_error = 0.0f; ///< bound of a point's distance from its face, scene units

    std::vector<std::uint32_t> apart;  ///< ascending; places of shared faces to be stored on their
                                       ///<     own before all else, as set_apart says
    std::vector<SharedPart> shared;    ///< as in the mesh
    std::vector<std::uint32_t> copies; ///< [copies] of which shared part
    std::vector<MapContact> own_contacts; ///< by map: those of one copy, or of shared faces where
                                          ///<     they are stored, with what stands about it
    CopyFinder finder;                    ///< of the copies
    std::vector<MapId> first_map_of_copy; ///< [copies]

    /// Returns the number of stored faces.
    std::size_t face_count() const { return map_of_face.size(); }
    /// Returns the number of faces and maps with those of copies.
    std::size_t all_face_count() const { return copies.empty() ? face_count() : finder.end(); }
    MapId all_map_count() const
    {
        return copies.empty() ? map_count
                              : first_map_of_copy.back() + shared[copies.back()].map_count;
    }
    FaceId stored_face(FaceId face) const
    {
        if (face < map_of_face.size()) [[likely]]
            return face;
        const std::uint32_t copy = finder.copy_of(face);
        return shared[copies[copy]].first_face + (face - finder.first_face(copy));
    }
    /// Returns the map of a face; kNone for a degenerate one.
    MapId map_of(FaceId face) const
    {
        if (face < map_of_face.size()) [[likely]]
            return map_of_face[face];
        const std::uint32_t copy = finder.copy_of(face);
        const SharedPart& part = shared[copies[copy]];
        const MapId map = map_of_face[part.first_face + (face - finder.first_face(copy))];
        return map == kNone ? kNone : first_map_of_copy[copy] + (map - part.first_map);
    }
    bool is_closed(FaceId face) const { return closed[stored_face(face)] != 0; }
    bool is_flipped(FaceId face) const { return flipped[stored_face(face)] != 0; }
};

/// Returns the shared part that has a map of stored faces; kNone: it is of no shared faces. Cost:
/// logarithmic.
std::uint32_t part_of_map(const Partition& partition, MapId map);

/// Sets what follows from the shared parts and the copies.  The faces and maps of all must be fewer
/// than kNone.
void index_copies(Partition& partition);

} // namespace hipmap
