#include "preprocess/partition/map_trees.h"

#include <tbb/parallel_for.h>

namespace hipmap {

std::vector<FaceTree> trees_of_maps(const TriangleMesh& mesh, const SharedMaps& maps,
                                    std::span<const std::uint8_t> wanted)
{
    const auto is_wanted = [&](FaceId face) {
        return maps.map_of_face[face] != kNone && wanted[maps.map_of_face[face]] != 0;
    };
    std::vector<std::uint32_t> end(maps.count + std::size_t{1}, 0); // of the faces of each map
    for (FaceId face = 0; face < mesh.face_count(); ++face)
        if (is_wanted(face))
            ++end[maps.map_of_face[face] + std::size_t{1}];
    for (std::size_t map = 0; map < maps.count; ++map)
        end[map + 1] += end[map];
    std::vector<FaceId> faces(end.back());
    for (FaceId face = 0; face < mesh.face_count(); ++face)
        if (is_wanted(face))
            faces[end[maps.map_of_face[face]]++] = face;
    std::vector<FaceTree> trees(maps.count);
    tbb::parallel_for(std::size_t{0}, trees.size(), [&](std::size_t map) {
        const std::uint32_t begin = map == 0 ? 0 : end[map - 1];
        if (begin < end[map])
            trees[map] = FaceTree(mesh, std::span(faces).subspan(begin, end[map] - begin));
    });
    return trees;
}

} // namespace hipmap
