#include "common/scene/gltf_skin.h"

#include "common/scene/gltf_accessor.h"
#include "common/scene/raw_scene.h"

namespace hipmap {

namespace {

void read_matrices(const tinygltf::Model& model, int accessor, const std::filesystem::path& path,
                   const std::string& place, GltfSkin& skin)
{
    const GltfAccessor matrices(model, accessor, path);
    if (matrices.type() != TINYGLTF_TYPE_MAT4 ||
        matrices.component_type() != TINYGLTF_COMPONENT_TYPE_FLOAT ||
        matrices.size() < skin.joints.size())
        throw scene_error(path, place + ".inverseBindMatrices",
                          "must be a matrix for each joint; the file is damaged, export it again");
    for (std::size_t j = 0; j < skin.joints.size(); ++j) {
        glm::dmat4& matrix = skin.from_mesh[j];
        matrix = matrices.mat4(j);
        for (int column = 0; column < 4; ++column)
            matrix[column][3] = column == 3 ? 1 : 0; // affine, up to rounding
        if (!is_finite_transform(matrix))
            throw scene_error(path, place + ".inverseBindMatrices",
                              "is not finite; repair the armature and export it again");
    }
}

} // namespace

std::vector<GltfSkin> read_gltf_skins(const tinygltf::Model& model,
                                      const std::filesystem::path& path)
{
    std::vector<GltfSkin> out;
    for (std::size_t i = 0; i < model.skins.size(); ++i) {
        const tinygltf::Skin& from = model.skins[i];
        GltfSkin skin{{from.joints.begin(), from.joints.end()},
                      std::vector<glm::dmat4>(from.joints.size(), glm::dmat4(1.0))};
        if (from.inverseBindMatrices >= 0)
            read_matrices(model, from.inverseBindMatrices, path, "skins[" + std::to_string(i) + "]",
                          skin);
        out.push_back(std::move(skin));
    }
    return out;
}

std::vector<const glm::dmat4*> transforms_by_node(const std::vector<PlacedNode>& nodes,
                                                  std::size_t count)
{
    std::vector<const glm::dmat4*> out(count, nullptr);
    for (const PlacedNode& at : nodes)
        out[at.node] = &at.to_world;
    return out;
}

std::vector<glm::dmat4> place_joints(const GltfSkin& skin,
                                     const std::vector<const glm::dmat4*>& to_world)
{
    std::vector<glm::dmat4> out;
    for (std::size_t j = 0; j < skin.joints.size(); ++j) {
        const glm::dmat4* const joint = to_world[skin.joints[j]];
        if (joint == nullptr)
            return {};
        out.push_back(*joint * skin.from_mesh[j]);
    }
    return out;
}

const std::vector<double>& morph_weights(const tinygltf::Model& model, const tinygltf::Node& node)
{
    return node.weights.empty() ? model.meshes[static_cast<std::size_t>(node.mesh)].weights
                                : node.weights;
}

} // namespace hipmap
