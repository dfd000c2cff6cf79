#pragma once

#include "tests/support/gltf_file.h"
#include "tests/support/tiny_meshes.h"

#include <numeric>

namespace hipmap::tiny {

/// How a mesh is written into a file.
struct Placement {
    std::string name = "as it is";
    glm::dmat4 to_world{1.0};    ///< of the root node
    std::vector<FaceId> order{}; ///< [F] the mesh's face at each place of the file; empty: as it is
    bool turned = false;         ///< every face is wound the other way
    std::uint32_t objects = 1;   ///< into which the faces are cut
    bool some_mirrored = false;  ///< every other object is the mirror image of what its node shows

    FaceId face_at(FaceId place) const { return order.empty() ? place : order[place]; }
};

inline json matrix_of(const glm::dmat4& m)
{
    json numbers = json::array();
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            numbers.push_back(m[column][row]);
    return numbers;
}

/// Hangs all that the scene shows below a new root node.
inline void hang_below(GltfFile& file, const glm::dmat4& to_world)
{
    json& roots = file.root["scenes"][0]["nodes"];
    file.root["nodes"].push_back({{"matrix", matrix_of(to_world)}, {"children", roots}});
    roots = json::array({file.root["nodes"].size() - 1});
}

/// The places of an object's faces in the file, [begin, end), as indices.
inline std::vector<std::uint16_t> indices_of(const TriangleMesh& mesh, const Placement& placement,
                                             std::size_t begin, std::size_t end, bool swapped)
{
    std::vector<std::uint16_t> indices;
    for (std::size_t place = begin; place < end; ++place) {
        glm::uvec3 c = mesh.corners[placement.face_at(static_cast<FaceId>(place))];
        if (swapped)
            std::swap(c.y, c.z);
        for (int i = 0; i < 3; ++i)
            indices.push_back(static_cast<std::uint16_t>(c[i]));
    }
    return indices;
}

/// A mesh of fewer than 65,536 vertices as a file.
inline GltfFile placed(const TriangleMesh& mesh, const Placement& placement)
{
    GltfFile file;
    std::vector<float> xyz, mirror_xyz;
    for (const glm::vec3& p : mesh.positions) {
        xyz.insert(xyz.end(), {p.x, p.y, p.z});
        mirror_xyz.insert(mirror_xyz.end(), {-p.x, p.y, p.z});
    }
    const int positions = file.add_vectors(xyz);
    const int mirror_positions = file.add_vectors(mirror_xyz);
    json nodes = json::array();
    for (std::size_t i = 0; i < placement.objects; ++i) {
        const std::size_t begin = i * mesh.face_count() / placement.objects;
        const std::size_t end = (i + 1) * mesh.face_count() / placement.objects;
        if (begin == end)
            continue;
        const bool mirrored = placement.some_mirrored && i % 2 == 1;
        const bool swapped = mirrored != placement.turned;
        const int indices = file.add_indices(indices_of(mesh, placement, begin, end, swapped));
        file.root["meshes"].push_back(
            {{"primitives",
              {{{"attributes", {{"POSITION", mirrored ? mirror_positions : positions}}},
                {"indices", indices}}}}});
        nodes.push_back({{"mesh", file.root["meshes"].size() - 1}});
        if (mirrored)
            nodes.back()["scale"] = {-1, 1, 1};
    }
    file.root["nodes"] = nodes;
    std::vector<std::size_t> roots(nodes.size());
    std::iota(roots.begin(), roots.end(), std::size_t{0});
    file.root["scenes"][0]["nodes"] = roots;
    hang_below(file, placement.to_world);
    return file;
}

/// The file that `bytes` of a .glb are.
inline GltfFile read_glb(const std::filesystem::path& path)
{
    std::ifstream in(path, std::ios::binary);
    const std::string all((std::istreambuf_iterator<char>(in)), {});
    std::uint32_t length = 0;
    std::memcpy(&length, all.data() + 12, sizeof length);
    return {json::parse(all.substr(20, length)), all.substr(28 + length)};
}

} // namespace hipmap::tiny
