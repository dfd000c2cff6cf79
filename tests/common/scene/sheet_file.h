#pragma once

#include "tests/common/scene/tiny_gltf_file.h"

#include <catch2/catch.hpp>
#include <draco/compression/encode.h>
#include <meshoptimizer.h>

#include <cmath>

namespace hipmap::tiny {

inline constexpr std::uint32_t kSide = 8; ///< quads along a side of the bumpy sheet
inline constexpr std::uint32_t kRow = kSide + 1;

/// A sheet in the unit square, one vertex at each grid point.
struct Sheet {
    std::vector<float> positions, normals;
    std::vector<std::uint32_t> indices;
};

inline Sheet bumpy_sheet()
{
    Sheet sheet;
    for (std::uint32_t y = 0; y < kRow; ++y)
        for (std::uint32_t x = 0; x < kRow; ++x) {
            const float u = static_cast<float>(x) / kSide, v = static_cast<float>(y) / kSide;
            const glm::vec3 n = glm::normalize(glm::vec3(0.4f * std::cos(3 * u), 0.2f * v, 1.0f));
            sheet.positions.insert(sheet.positions.end(), {u, v, 0.2f * std::sin(3 * u) * v});
            sheet.normals.insert(sheet.normals.end(), {n.x, n.y, n.z});
        }
    for (std::uint32_t y = 0; y < kSide; ++y)
        for (std::uint32_t x = 0; x < kSide; ++x) {
            const std::uint32_t a = y * kRow + x, b = a + 1, c = a + kRow, d = c + 1;
            sheet.indices.insert(sheet.indices.end(), {a, b, d, a, d, c});
        }
    return sheet;
}

/// A file whose one mesh has the sheet's accessors without data.
inline GltfFile empty_sheet_file(const Sheet& sheet)
{
    GltfFile file;
    const std::size_t vertices = sheet.positions.size() / 3;
    file.root["accessors"] = {
        {{"componentType", 5126}, {"count", vertices}, {"type", "VEC3"}},
        {{"componentType", 5126}, {"count", vertices}, {"type", "VEC3"}},
        {{"componentType", 5125}, {"count", sheet.indices.size()}, {"type", "SCALAR"}}};
    file.root["meshes"] = {
        {{"primitives", {{{"attributes", {{"POSITION", 0}, {"NORMAL", 1}}}, {"indices", 2}}}}}};
    file.root["nodes"] = {{{"name", "sheet"}, {"mesh", 0}}};
    return file;
}

inline int add_view(GltfFile& file, const void* data, std::size_t size)
{
    file.root["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", file.bytes.size()}, {"byteLength", size}});
    file.bytes.append(static_cast<const char*>(data), size);
    file.bytes.resize((file.bytes.size() + 3) / 4 * 4);
    return static_cast<int>(file.root["bufferViews"].size()) - 1;
}

inline GltfFile plain_file(const Sheet& sheet)
{
    GltfFile file = empty_sheet_file(sheet);
    json& accessors = file.root["accessors"];
    accessors[0]["bufferView"] = add_view(file, sheet.positions.data(), sheet.positions.size() * 4);
    accessors[1]["bufferView"] = add_view(file, sheet.normals.data(), sheet.normals.size() * 4);
    accessors[2]["bufferView"] = add_view(file, sheet.indices.data(), sheet.indices.size() * 4);
    return file;
}

inline int add_vectors(draco::Mesh& mesh, draco::GeometryAttribute::Type type,
                       const std::vector<float>& xyz)
{
    const auto count = static_cast<std::uint32_t>(xyz.size() / 3);
    draco::GeometryAttribute attribute;
    attribute.Init(type, nullptr, 3, draco::DT_FLOAT32, false, 12, 0);
    const int id = mesh.AddAttribute(attribute, true, count);
    for (std::uint32_t i = 0; i < count; ++i)
        mesh.attribute(id)->SetAttributeValue(draco::AttributeValueIndex(i), &xyz[3 * i]);
    return static_cast<int>(mesh.attribute(id)->unique_id());
}

inline GltfFile draco_file(const Sheet& sheet, int method)
{
    draco::Mesh mesh;
    mesh.set_num_points(static_cast<std::uint32_t>(sheet.positions.size() / 3));
    const int position = add_vectors(mesh, draco::GeometryAttribute::POSITION, sheet.positions);
    const int normal = add_vectors(mesh, draco::GeometryAttribute::NORMAL, sheet.normals);
    for (std::size_t i = 0; i < sheet.indices.size(); i += 3)
        mesh.AddFace({draco::PointIndex(sheet.indices[i]), draco::PointIndex(sheet.indices[i + 1]),
                      draco::PointIndex(sheet.indices[i + 2])});
    draco::Encoder encoder;
    encoder.SetEncodingMethod(method);
    encoder.SetSpeedOptions(0, 0);
    encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, 14);
    encoder.SetAttributeQuantization(draco::GeometryAttribute::NORMAL, 10);
    draco::EncoderBuffer out;
    REQUIRE(encoder.EncodeMeshToBuffer(mesh, &out).ok());

    GltfFile file = empty_sheet_file(sheet);
    const int view = add_view(file, out.data(), out.size());
    file.root["extensionsRequired"] = {"KHR_draco_mesh_compression"};
    file.root["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"] = {
        {"bufferView", view}, {"attributes", {{"POSITION", position}, {"NORMAL", normal}}}};
    return file;
}

/// Moves a view's data into buffer 1, which is not in the file, and leaves `packed` in its place.
inline void pack_view(GltfFile& file, const std::vector<unsigned char>& packed, json view,
                      json extension)
{
    extension["buffer"] = 0;
    extension["byteOffset"] = file.bytes.size();
    extension["byteLength"] = packed.size();
    file.bytes.append(packed.begin(), packed.end());
    json& buffers = file.root["buffers"];
    const std::size_t offset = buffers[1]["byteLength"];
    const std::size_t length =
        extension["count"].get<std::size_t>() * extension["byteStride"].get<std::size_t>();
    view["buffer"] = 1;
    view["byteOffset"] = offset;
    view["byteLength"] = length;
    view["extensions"]["EXT_meshopt_compression"] = extension;
    buffers[0]["byteLength"] = file.bytes.size();
    buffers[1]["byteLength"] = offset + length;
    file.root["bufferViews"].push_back(view);
}

inline std::vector<unsigned char> pack_vertices(const void* data, std::size_t count,
                                                std::size_t stride)
{
    std::vector<unsigned char> packed(meshopt_encodeVertexBufferBound(count, stride));
    packed.resize(meshopt_encodeVertexBuffer(packed.data(), packed.size(), data, count, stride));
    return packed;
}

/// Positions by the exponential filter, normals by the octahedral one.
inline GltfFile meshopt_file(const Sheet& sheet, const std::string& index_mode)
{
    const std::size_t vertices = sheet.positions.size() / 3, corners = sheet.indices.size();
    std::vector<std::uint32_t> positions(sheet.positions.size());
    meshopt_encodeFilterExp(positions.data(), vertices, 12, 20, sheet.positions.data());
    std::vector<float> four;
    for (std::size_t i = 0; i < vertices; ++i)
        four.insert(four.end(), {sheet.normals[3 * i], sheet.normals[3 * i + 1],
                                 sheet.normals[3 * i + 2], 0.0f});
    std::vector<std::int16_t> normals(4 * vertices);
    meshopt_encodeFilterOct(normals.data(), vertices, 8, 12, four.data());
    std::vector<unsigned char> indices(index_mode == "TRIANGLES"
                                           ? meshopt_encodeIndexBufferBound(corners, vertices)
                                           : meshopt_encodeIndexSequenceBound(corners, vertices));
    indices.resize(index_mode == "TRIANGLES"
                       ? meshopt_encodeIndexBuffer(indices.data(), indices.size(),
                                                   sheet.indices.data(), corners)
                       : meshopt_encodeIndexSequence(indices.data(), indices.size(),
                                                     sheet.indices.data(), corners));

    GltfFile file = empty_sheet_file(sheet);
    file.root["extensionsRequired"] = {"EXT_meshopt_compression", "KHR_mesh_quantization"};
    file.root["buffers"] = {
        {{"byteLength", 0}},
        {{"byteLength", 0}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}}};
    pack_view(file, pack_vertices(positions.data(), vertices, 12), {{"byteStride", 12}},
              {{"mode", "ATTRIBUTES"},
               {"filter", "EXPONENTIAL"},
               {"count", vertices},
               {"byteStride", 12}});
    pack_view(
        file, pack_vertices(normals.data(), vertices, 8), {{"byteStride", 8}},
        {{"mode", "ATTRIBUTES"}, {"filter", "OCTAHEDRAL"}, {"count", vertices}, {"byteStride", 8}});
    pack_view(file, indices, json::object(),
              {{"mode", index_mode}, {"count", corners}, {"byteStride", 4}});
    json& accessors = file.root["accessors"];
    accessors[1]["componentType"] = 5122;
    accessors[1]["normalized"] = true;
    for (std::size_t i = 0; i < 3; ++i)
        accessors[i]["bufferView"] = i;
    return file;
}

} // namespace hipmap::tiny
