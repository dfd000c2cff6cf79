#pragma once

#include "render/maps/photon_maps.h"
#include "render/shading/bsdf.h"

#include <limits>
#include <vector>

namespace hipmap {

/// Where photons are looked for.
struct PhotonQuery {
    glm::vec3 position; ///< scene units
    glm::vec3 normal;   ///< geometric, unit, on the side that is looked at
    FaceId face = kNone;
    std::uint8_t side = 0;
    float radius = std::numeric_limits<float>::infinity(); ///< nothing farther counts
    const Bsdf* bsdf = nullptr;     ///< whose diffuse lobe gathers; none: Lambert
    glm::vec3 shading_normal{0.0f}; ///< the two that its shape depends on, unit
    glm::vec3 toward_eye{0.0f};
};

/// What the searches of one thread did; sums are independent of the order of queries.
struct SearchStatistics {
    std::uint64_t queries = 0;
    std::uint64_t local_searches = 0; ///< begun in a local map
    std::uint64_t skipped = 0;        ///< not begun: the filter radius exceeds the limiting radius
    std::uint64_t abandoned =
        0; ///< begun, ran into the limiting radius, repeated in the shared map
    std::uint64_t photons_found = 0;

    SearchStatistics& operator+=(const SearchStatistics& other);
};

/// Memory that one thread lends to its searches, so that none allocates.
struct SearchScratch {
    std::vector<Neighbour> heap; ///< [k]
    SearchStatistics statistics;

    explicit SearchScratch(const MapOptions& options) : heap(options.neighbours) {}
};

/// Distance from a point of `face` to the nearest edge across which its shared map goes on;
/// infinite if there is none.  Algorithm 4 of the thesis, docs/photon_maps.md (6).
float limiting_radius(const TriangleMesh& mesh, const Partition& partition, FaceId face,
                      const glm::vec3& point);

/// The radius within which k photons would lie were those of the query's map spread evenly over it,
/// docs/photon_maps.md (5); infinite for an empty map or a face without one.
float even_radius(const PhotonMaps& maps, const Partition& partition, const PhotonQuery& query);

/// The k nearest photons of the query's map (fewer if there are no more within the radius), nearest
/// first; valid until the scratch is used again.  A face without a map has none.
/// Mode thesis looks in the face's local map first; what it returns is what the shared map would.
std::span<const Neighbour> find_photons(const PhotonMaps& maps, const TriangleMesh& mesh,
                                        const Partition& partition, const PhotonQuery& query,
                                        SearchScratch& scratch);

/// The same from the first tier alone, of the photons that `accept(photon index)` lets through.
template <typename Accept>
std::span<const Neighbour> find_in_shared(const PhotonMaps& maps, const Partition& partition,
                                          const PhotonQuery& query, SearchScratch& scratch,
                                          const Accept& accept)
{
    const bool one_map = maps.options.mode == MapMode::global;
    const MapId map = one_map ? 0 : partition.map_of_face[query.face];
    if (map == kNone)
        return {};
    NeighbourHeap heap(scratch.heap, query.radius * query.radius);
    const PhotonTree tree = maps.tree(maps.map_index(map, query.side));
    if (one_map) {
        // Photons of all surfaces are in one map: only light that fell on the side looked at
        // counts.
        search_tree(
            tree, query.position,
            [&](std::uint32_t i) {
                return glm::dot(maps.photons[i].direction, query.normal) > 0 && accept(i);
            },
            heap);
    } else {
        search_tree(tree, query.position, accept, heap);
    }
    return heap.sorted();
}

} // namespace hipmap
