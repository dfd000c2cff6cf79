#include "common/scene/gltf_accessor.h"

#include "common/scene/raw_scene.h"

#include <algorithm>
#include <cstring>

namespace hipmap {

namespace {

template <typename T>
double load(const unsigned char* bytes)
{
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return static_cast<double>(value);
}

/// Bytes of a component type that glTF 2.0 allows; 0 for another.
std::size_t component_size(int component_type)
{
    switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
        return 4;
    default:
        return 0;
    }
}

/// What a normalised integer's largest value stands for 1 at (glTF 2.0, section 3.11).
double full_scale(int component_type)
{
    switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
        return 127;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return 255;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
        return 32767;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return 65535;
    default:
        return 1;
    }
}

std::size_t all_bytes(const tinygltf::Model& model)
{
    std::size_t sum = 0;
    for (const tinygltf::Buffer& buffer : model.buffers)
        sum += buffer.data.size();
    return sum;
}

} // namespace

double ElementSpan::component(std::size_t i, int c) const
{
    if (!first)
        return 0.0;
    const unsigned char* const bytes =
        first + i * stride + static_cast<std::size_t>(c) * component_size(component_type);
    switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
        return load<std::int8_t>(bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return load<std::uint8_t>(bytes);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
        return load<std::int16_t>(bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return load<std::uint16_t>(bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        return load<std::uint32_t>(bytes);
    default:
        return load<float>(bytes);
    }
}

GltfAccessor::GltfAccessor(const tinygltf::Model& model, int index,
                           const std::filesystem::path& path)
    : path_(path), place_("accessors[" + std::to_string(index) + "]")
{
    const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(index)];
    count_ = accessor.count;
    type_ = accessor.type;
    normalized_ = accessor.normalized;
    if (accessor.bufferView >= 0) {
        base_ = elements(model, {.view = accessor.bufferView,
                                 .offset = accessor.byteOffset,
                                 .type = accessor.type,
                                 .component_type = accessor.componentType,
                                 .count = accessor.count});
    } else {
        // Nothing in the file backs the count, so nothing else bounds what it makes us allocate.
        if (count_ > all_bytes(model))
            fail("has " + std::to_string(count_) + " elements but no data");
        base_.component_type = accessor.componentType;
    }
    if (accessor.sparse.isSparse)
        read_sparse(model, accessor);
}

void GltfAccessor::read_sparse(const tinygltf::Model& model, const tinygltf::Accessor& accessor)
{
    const auto& sparse = accessor.sparse;
    const int index_type = sparse.indices.componentType;
    if (sparse.count < 1 || static_cast<std::size_t>(sparse.count) > count_ ||
        sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0 ||
        (index_type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE &&
         index_type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT &&
         index_type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT))
        fail("has a damaged sparse part");
    const auto changed = static_cast<std::size_t>(sparse.count);
    const ElementSpan indices =
        elements(model, {.view = sparse.indices.bufferView,
                         .offset = static_cast<std::size_t>(sparse.indices.byteOffset),
                         .type = TINYGLTF_TYPE_SCALAR,
                         .component_type = index_type,
                         .count = changed});
    sparse_values_ = elements(model, {.view = sparse.values.bufferView,
                                      .offset = static_cast<std::size_t>(sparse.values.byteOffset),
                                      .type = accessor.type,
                                      .component_type = accessor.componentType,
                                      .count = changed});
    sparse_indices_.reserve(changed);
    for (std::size_t i = 0; i < changed; ++i) {
        const auto at = static_cast<std::uint32_t>(indices.component(i, 0));
        if (at >= count_ || (i > 0 && at <= sparse_indices_.back()))
            fail("has a sparse index that is out of range or out of order");
        sparse_indices_.push_back(at);
    }
}

ElementSpan GltfAccessor::elements(const tinygltf::Model& model, const ElementLayout& layout) const
{
    const tinygltf::BufferView& view = model.bufferViews[static_cast<std::size_t>(layout.view)];
    const int components =
        tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(layout.type));
    const std::size_t component = component_size(layout.component_type);
    if (components < 1 || component == 0)
        fail("has an unknown type or component type");
    const std::size_t size = component * static_cast<std::size_t>(components);
    const std::size_t stride = view.byteStride == 0 ? size : view.byteStride;
    if (stride < size)
        fail("has elements that overlap");
    if (layout.count < 1 || layout.offset > view.byteLength ||
        size > view.byteLength - layout.offset ||
        layout.count - 1 > (view.byteLength - layout.offset - size) / stride)
        fail("runs past the end of its bufferView");
    const tinygltf::Buffer& buffer = model.buffers[static_cast<std::size_t>(view.buffer)];
    return {buffer.data.data() + view.byteOffset + layout.offset, stride, layout.component_type};
}

double GltfAccessor::value(std::size_t i, int c) const
{
    const auto at = std::lower_bound(sparse_indices_.begin(), sparse_indices_.end(), i);
    const bool changed = at != sparse_indices_.end() && *at == i;
    const double number =
        changed
            ? sparse_values_.component(static_cast<std::size_t>(at - sparse_indices_.begin()), c)
            : base_.component(i, c);
    return normalized_ ? std::max(-1.0, number / full_scale(base_.component_type)) : number;
}

glm::dvec2 GltfAccessor::vec2(std::size_t i) const
{
    return {value(i, 0), value(i, 1)};
}

glm::dvec3 GltfAccessor::vec3(std::size_t i) const
{
    return {value(i, 0), value(i, 1), value(i, 2)};
}

glm::dvec4 GltfAccessor::vec4(std::size_t i) const
{
    return {value(i, 0), value(i, 1), value(i, 2), value(i, 3)};
}

glm::dmat4 GltfAccessor::mat4(std::size_t i) const
{
    glm::dmat4 out(0.0);
    for (int c = 0; c < 16; ++c)
        out[c / 4][c % 4] = value(i, c);
    return out;
}

std::uint32_t GltfAccessor::index(std::size_t i) const
{
    return static_cast<std::uint32_t>(value(i, 0));
}

void GltfAccessor::fail(const std::string& what) const
{
    throw scene_error(path_, place_, what + "; the file is damaged, export it again");
}

} // namespace hipmap
