#pragma once

#include "common/partition/partition.h"
#include "render/maps/packed_direction.h"
#include "render/maps/photon_powers.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace hipmap {

struct MapOptions {
    std::uint32_t neighbours = 50; ///< k, at least 1
    bool directions = false;       ///< keep them: a lobe that is not separable will gather
};

/// The photons of a shared map and side, packed.
struct PhotonMap {
    WideTree tree;
    PhotonPowers powers;
    std::vector<FaceId> faces;               ///< [n] by slot
    std::vector<PackedDirection> directions; ///< [n] by slot; empty if nobody asks for them
    std::uint8_t side = 0;

    /// Returns the unit direction from which the photon came.  Only if directions are kept.
    glm::vec3 direction(std::uint32_t slot) const { return unpack_direction(directions[slot]); }
    /// Returns the bytes of the arrays.
    std::size_t bytes() const
    {
        return tree.bytes() + powers.bytes() + faces.size() * sizeof(FaceId) +
               directions.size() * sizeof(PackedDirection);
    }
};

/// A hash of all that a map is built from: its photons in order, the unit of their powers and what
/// is kept of them.
using MapContent = std::array<std::uint64_t, 2>;

/// The shared maps of one kind of photon (caustic or global), one for each shared map of the
/// partition and side that holds photons (Larsen and Christensen 2003).  Read-only once built: any
/// number of threads may search.
struct PhotonMaps {
    MapOptions options;
    std::uint64_t size = 0; ///< photons
    PowerScale power_scale;
    std::vector<PhotonMap> maps;
    std::vector<std::uint32_t> map_of; ///< by map_index: the place in `maps`; kNone: no photon.
                                       ///< Empty without photons
    std::vector<std::uint64_t> held;   ///< ascending; the map_index of each of `maps` instead of
                                       ///< map_of, where few of very many maps hold photons
    std::vector<MapContent> contents;  ///< [maps] if other photons may take maps over; else empty
    std::uint64_t taken_over = 0;      ///< maps that were built for other photons

    /// Returns the index into map_of.
    static std::size_t map_index(MapId map, std::uint8_t side)
    {
        return std::size_t{2} * map + side % 2u;
    }
    /// Returns the index into `maps`; kNone if there is no photon.
    std::uint32_t place(MapId map, std::uint8_t side) const
    {
        if (!map_of.empty()) [[likely]]
            return map_of[map_index(map, side)];
        const auto found = std::ranges::lower_bound(held, map_index(map, side));
        return found == held.end() || *found != map_index(map, side)
                   ? kNone
                   : static_cast<std::uint32_t>(found - held.begin());
    }
    /// Returns the map; null if there is no photon.
    const PhotonMap* map_at(MapId map, std::uint8_t side) const
    {
        const std::uint32_t found = place(map, side);
        return found == kNone ? nullptr : &maps[found];
    }
    /// Returns the bytes of the arrays.
    std::size_t bytes() const;
    /// Returns the number of photons in the largest map.
    std::uint64_t largest_map() const;
};

/// Returns sqrt(A k / (pi N)), docs/photon_maps.md (5); infinite without photons.
float filter_radius(double area, std::uint32_t neighbours, std::uint64_t photons);

/// The photon data that a map keeps besides the tree.
struct PhotonPacking {
    PowerScale scale;
    bool directions = false;
};

/// Builds the map of some photons of one side.  points: as build_wide_tree left them, at least one;
/// they give the photons' numbers.  In parallel.
PhotonMap pack_photons(WideTree tree, std::span<const TreePoint> points,
                       const std::vector<Photon>& photons, const PhotonPacking& packing);

/// Throws InputError if there are 2^32 photons or more, which have no numbers.
void check_photon_count(const std::vector<Photon>& photons);

/// Splits `photons`, in the order of (path, bounce), into shared maps and builds their trees, in
/// parallel.  O(n log n).  Same photons, same maps, at any thread count.  About 23.7 bytes a photon
/// are kept, 27.7 with directions.  No photons: no maps, nothing is found.  Throws InputError for
/// 2^32 photons or more.
/// previous: maps of other photons, or empty ones.  Maps that would be built from the same content
/// are moved from there, which gives the same bits and costs a hash of the photons (an XXH3 of 44
/// bytes each).  Null: all are built, and none has a hash.
PhotonMaps build_photon_maps(const std::vector<Photon>& photons, const Partition& partition,
                             const MapOptions& options, PhotonMaps* previous = nullptr);

} // namespace hipmap
