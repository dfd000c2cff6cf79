#include "preprocess/partition/share_maps.h"

#include "preprocess/mesh/disjoint_sets.h"

namespace hipmap {

SharedMaps share_maps(std::span<const EdgeClass> edge_class,
                      std::span<const std::uint32_t> opposite)
{
    const std::size_t face_count = edge_class.size() / 3;
    DisjointSets sets(face_count);
    for (std::uint32_t edge = 0; edge < edge_class.size(); ++edge)
        if (edge_class[edge] == EdgeClass::connected)
            sets.unite(edge / 3, opposite[edge] / 3);

    SharedMaps maps;
    maps.map_of_face.resize(face_count);
    for (FaceId face = 0; face < face_count; ++face) {
        const FaceId root = sets.root(face); // the lowest face of the map
        if (edge_class[std::size_t{3} * face] == EdgeClass::degenerate)
            maps.map_of_face[face] = kNone;
        else
            maps.map_of_face[face] = root == face ? maps.count++ : maps.map_of_face[root];
    }
    return maps;
}

} // namespace hipmap
