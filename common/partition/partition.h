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

/// Says which faces may share photons; made by preprocess, read by render.  All arrays are by
/// FaceId of the scene whose fingerprint it holds.  An edge of face f is numbered 3 f + c and runs
/// from corner c to corner (c + 1) mod 3.
struct Partition {
    Fingerprint scene;
    double angle_threshold = 0.0;      ///< radians
    std::uint32_t map_count = 0;       ///< shared maps: ids 0..map_count-1 by lowest face
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
    std::vector<MapContact> contacts;         ///< by map; boundaries where no edge is
    float position_error = 0.0f; ///< bound of a point's distance from its face, scene units

    std::size_t face_count() const { return map_of_face.size(); }
};

} // namespace hipmap
