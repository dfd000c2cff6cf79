#include "common/scene/gltf_instances.h"

#include "common/scene/gltf_accessor.h"
#include "common/scene/raw_scene.h"

#include <optional>

namespace hipmap {

namespace {

constexpr const char* kInstancing = "EXT_mesh_gpu_instancing";

/// The accessors of one node's instances; those it leaves out stand for no change.
struct InstanceAccessors {
    std::optional<GltfAccessor> translation, rotation, scale;
    std::size_t count = 1;
};

std::string instancing_of(std::size_t node)
{
    return "nodes[" + std::to_string(node) + "]." + kInstancing;
}

InstanceAccessors instance_accessors(const tinygltf::Model& model, std::size_t node,
                                     const std::filesystem::path& path)
{
    InstanceAccessors out;
    const auto& extensions = model.nodes[node].extensions;
    const auto instancing = extensions.find(kInstancing);
    if (instancing == extensions.end())
        return out;
    const tinygltf::Value& attributes = instancing->second.Get("attributes");
    std::optional<std::size_t> count;
    const auto read = [&](const char* name, int type, std::optional<GltfAccessor>& accessor) {
        if (!attributes.Has(name))
            return;
        accessor.emplace(model, attributes.Get(name).GetNumberAsInt(), path);
        if (accessor->type() != type || (count && *count != accessor->size()))
            throw scene_error(path, instancing_of(node) + "." + name,
                              "is of the wrong type or count; the file is damaged, export it "
                              "again");
        count = accessor->size();
    };
    read("TRANSLATION", TINYGLTF_TYPE_VEC3, out.translation);
    read("ROTATION", TINYGLTF_TYPE_VEC4, out.rotation);
    read("SCALE", TINYGLTF_TYPE_VEC3, out.scale);
    out.count = count.value_or(1);
    return out;
}

} // namespace

std::size_t count_instances(const tinygltf::Model& model, std::size_t node,
                            const std::filesystem::path& path)
{
    return instance_accessors(model, node, path).count;
}

std::vector<glm::dmat4> place_instances(const tinygltf::Model& model, const PlacedNode& at,
                                        const std::filesystem::path& path)
{
    const InstanceAccessors instances = instance_accessors(model, at.node, path);
    std::vector<glm::dmat4> placed;
    placed.reserve(instances.count);
    for (std::size_t i = 0; i < instances.count; ++i) {
        NodeTransform local;
        if (instances.translation)
            local.translation = instances.translation->vec3(i);
        if (instances.rotation)
            local.rotation = instances.rotation->vec4(i);
        if (instances.scale)
            local.scale = instances.scale->vec3(i);
        placed.push_back(at.to_world * to_matrix(local));
        if (!is_finite_transform(placed.back()))
            throw scene_error(path, instancing_of(at.node) + ", instance " + std::to_string(i),
                              "its transform is not finite; correct it and export again");
    }
    return placed;
}

} // namespace hipmap
