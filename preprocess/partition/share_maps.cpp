#include "preprocess/partition/share_maps.h"

#include "preprocess/mesh/disjoint_sets.h"

#include <tbb/parallel_for.h>

namespace hipmap {

SharedMaps share_maps(std::span<const EdgeClass> edge_class,
                      std::span<const std::uint32_t> opposite)
{
    const std::size_t face_count = edge_class.size() / 3;
    DisjointSets sets(face_count);
    tbb::parallel_for(std::size_t{0}, edge_class.size(), [&](std::size_t edge) {
        if (edge_class[edge] == EdgeClass::connected && edge < opposite[edge])
            sets.unite(static_cast<FaceId>(edge / 3), opposite[edge] / 3);
    });

    SharedMaps maps;
    maps.map_of_face.resize(face_count);
    tbb::parallel_for(std::size_t{0}, face_count, [&](std::size_t face) {
        maps.map_of_face[face] = sets.root(static_cast<FaceId>(face)); // the lowest of the map
    });
    for (FaceId face = 0; face < face_count; ++face) {
        const FaceId root = maps.map_of_face[face];
        if (edge_class[std::size_t{3} * face] == EdgeClass::degenerate)
            maps.map_of_face[face] = kNone;
        else
            maps.map_of_face[face] = root == face ? maps.count++ : maps.map_of_face[root];
    }
    return maps;
}

} // namespace hipmap
