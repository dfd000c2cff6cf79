#include "common/scene/gltf_draco.h"

#include "common/scene/draco_mesh.h"
#include "common/scene/gltf_accessor.h"
#include "common/scene/raw_scene.h"

#include <array>
#include <cstring>
#include <map>

namespace hipmap {

namespace {

using nlohmann::json;
using Bytes = std::vector<unsigned char>;

constexpr const char* kDraco = "KHR_draco_mesh_compression";

/// The values of all points as T, one after another; empty if the attribute does not have them.
template <typename T>
Bytes point_values(const draco::Mesh& mesh, const draco::PointAttribute& attribute, int components)
{
    const std::size_t size = static_cast<std::size_t>(components) * sizeof(T);
    Bytes bytes(mesh.num_points() * size);
    std::array<T, 4> value{};
    for (draco::PointIndex point(0); point < mesh.num_points(); ++point) {
        const draco::AttributeValueIndex at = attribute.mapped_index(point);
        if (at.value() >= attribute.size() ||
            !attribute.ConvertValue(at, static_cast<std::int8_t>(components), value.data()))
            return {};
        std::memcpy(bytes.data() + point.value() * size, value.data(), size);
    }
    return bytes;
}

Bytes point_values(const draco::Mesh& mesh, const draco::PointAttribute& attribute,
                   const tinygltf::Accessor& accessor)
{
    const int components =
        tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type));
    if (components < 1 || components > 4 || attribute.num_components() != components)
        return {};
    switch (accessor.componentType) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
        return point_values<std::int8_t>(mesh, attribute, components);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return point_values<std::uint8_t>(mesh, attribute, components);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
        return point_values<std::int16_t>(mesh, attribute, components);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return point_values<std::uint16_t>(mesh, attribute, components);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        return point_values<std::uint32_t>(mesh, attribute, components);
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
        return point_values<float>(mesh, attribute, components);
    default:
        return {};
    }
}

Bytes corner_indices(const draco::Mesh& mesh)
{
    std::vector<std::uint32_t> corners;
    corners.reserve(3 * static_cast<std::size_t>(mesh.num_faces()));
    for (draco::FaceIndex face(0); face < mesh.num_faces(); ++face)
        for (const draco::PointIndex& corner : mesh.face(face))
            corners.push_back(corner.value());
    Bytes bytes(corners.size() * sizeof(std::uint32_t));
    if (!bytes.empty())
        std::memcpy(bytes.data(), corners.data(), bytes.size());
    return bytes;
}

class DracoReader {
  public:
    DracoReader(const GltfDocument& document, tinygltf::Model& model)
        : document_(document), model_(model)
    {
        for (const tinygltf::Buffer& buffer : model.buffers)
            encoded_left_ += buffer.data.size();
    }

    void read(std::size_t mesh, std::size_t index)
    {
        tinygltf::Primitive& primitive = model_.meshes[mesh].primitives[index];
        place_ = "meshes[" + std::to_string(mesh) + "].primitives[" + std::to_string(index) + "]." +
                 kDraco;
        const json& extension =
            document_.json["meshes"][mesh]["primitives"][index]["extensions"][kDraco];
        const auto view = extension["bufferView"].get<std::size_t>();
        const draco::Mesh& decoded = decode(view);
        for (const auto& [name, id] : extension["attributes"].items()) {
            const auto attribute = primitive.attributes.find(name);
            if (attribute != primitive.attributes.end())
                attribute->second =
                    attribute_accessor(decoded, {view, id.get<std::size_t>(), attribute->second});
        }
        const std::size_t corners = 3 * static_cast<std::size_t>(decoded.num_faces());
        if (primitive.mode == TINYGLTF_MODE_TRIANGLES && primitive.indices >= 0 &&
            accessor(primitive.indices).count != corners)
            fail("has " + std::to_string(corners) + " corners where its accessor has " +
                 std::to_string(accessor(primitive.indices).count));
        primitive.indices = index_accessor(decoded, view);
        primitive.mode = TINYGLTF_MODE_TRIANGLES; // a strip is decoded to triangles as well
    }

  private:
    struct AttributeKey {
        std::size_t view = 0, id = 0;
        int accessor = 0;
        auto operator<=>(const AttributeKey&) const = default;
    };

    const tinygltf::Accessor& accessor(int index) const
    {
        return model_.accessors[static_cast<std::size_t>(index)];
    }

    const draco::Mesh& decode(std::size_t view_index)
    {
        std::unique_ptr<draco::Mesh>& mesh = meshes_[view_index];
        if (mesh)
            return *mesh;
        const tinygltf::BufferView& view = model_.bufferViews[view_index];
        // Every byte is decoded once at most, or a small file could name a large part many times.
        if (view.byteLength > encoded_left_)
            fail("its bufferView overlaps others");
        encoded_left_ -= view.byteLength;
        const Bytes& data = model_.buffers[static_cast<std::size_t>(view.buffer)].data;
        mesh = decode_draco(std::span(data).subspan(view.byteOffset, view.byteLength));
        if (!mesh)
            fail("cannot be decoded");
        return *mesh;
    }

    int attribute_accessor(const draco::Mesh& mesh, const AttributeKey& key)
    {
        const auto known = accessors_.find(key);
        if (known != accessors_.end())
            return known->second;
        tinygltf::Accessor decoded = accessor(key.accessor);
        const draco::PointAttribute* const attribute =
            key.id < kNone ? mesh.GetAttributeByUniqueId(static_cast<std::uint32_t>(key.id))
                           : nullptr;
        if (!attribute)
            fail("has no attribute " + std::to_string(key.id));
        if (decoded.count != mesh.num_points())
            fail("has " + std::to_string(mesh.num_points()) + " vertices where its accessor has " +
                 std::to_string(decoded.count));
        Bytes bytes = point_values(mesh, *attribute, decoded);
        if (bytes.empty())
            fail("attribute " + std::to_string(key.id) + " is not of the type of its accessor");
        decoded.byteOffset = 0;
        return accessors_[key] = add_accessor(std::move(decoded), std::move(bytes));
    }

    int index_accessor(const draco::Mesh& mesh, std::size_t view)
    {
        const auto known = indices_.find(view);
        if (known != indices_.end())
            return known->second;
        tinygltf::Accessor corners;
        corners.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
        corners.type = TINYGLTF_TYPE_SCALAR;
        corners.count = 3 * static_cast<std::size_t>(mesh.num_faces());
        if (corners.count == 0)
            fail("has no faces");
        return indices_[view] = add_accessor(std::move(corners), corner_indices(mesh));
    }

    int add_accessor(tinygltf::Accessor&& decoded, Bytes&& bytes)
    {
        tinygltf::BufferView view;
        view.buffer = static_cast<int>(model_.buffers.size());
        view.byteLength = bytes.size();
        decoded.bufferView = static_cast<int>(model_.bufferViews.size());
        model_.buffers.emplace_back().data = std::move(bytes);
        model_.bufferViews.push_back(std::move(view));
        model_.accessors.push_back(std::move(decoded));
        return static_cast<int>(model_.accessors.size()) - 1;
    }

    [[noreturn]] void fail(const std::string& what) const
    {
        throw scene_error(document_.path, place_, what + "; the file is damaged, export it again");
    }

    const GltfDocument& document_;
    tinygltf::Model& model_;
    std::string place_;
    std::size_t encoded_left_ = 0; ///< bytes of the file that are not decoded yet
    std::map<std::size_t, std::unique_ptr<draco::Mesh>> meshes_; ///< by bufferView
    std::map<AttributeKey, int> accessors_;
    std::map<std::size_t, int> indices_; ///< by bufferView
};

/// Whether the accessor has no data but what is compressed.
bool lacks_data(const tinygltf::Model& model, int index)
{
    if (index < 0)
        return false;
    const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(index)];
    return accessor.bufferView < 0 && !accessor.sparse.isSparse;
}

bool is_compressed(const tinygltf::Model& model, const tinygltf::Primitive& primitive)
{
    const auto position = primitive.attributes.find("POSITION");
    return primitive.extensions.contains(kDraco) && position != primitive.attributes.end() &&
           (lacks_data(model, position->second) || lacks_data(model, primitive.indices));
}

} // namespace

void decode_draco_primitives(const GltfDocument& document, tinygltf::Model& model)
{
    DracoReader reader(document, model);
    for (std::size_t mesh = 0; mesh < model.meshes.size(); ++mesh)
        for (std::size_t i = 0; i < model.meshes[mesh].primitives.size(); ++i)
            if (is_compressed(model, model.meshes[mesh].primitives[i]))
                reader.read(mesh, i);
}

} // namespace hipmap
