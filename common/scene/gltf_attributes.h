#pragma once

#include "common/scene/gltf_document.h"
#include "common/scene/mesh.h"

#include <tiny_gltf.h>

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace hipmap {

/// Lists the attributes that the materials of a file need; others are not stored.
struct WantedAttributes {
    std::array<bool, 2> uv{}; ///< some texture reads TEXCOORD_0, TEXCOORD_1
    bool tangents = false;    ///< some texture gives directions on the surface
};

WantedAttributes find_wanted_attributes(const GltfDocument& document);

/// A primitive of a file and its place in it.
struct PrimitivePlace {
    const tinygltf::Model& model;
    const tinygltf::Primitive& primitive;
    const std::filesystem::path& path;
    const std::string& place;
};

/// The vertices of a primitive that its faces use.
struct UsedVertices {
    std::size_t of = 0;                      ///< vertices that the primitive has
    std::span<const std::uint32_t> vertices; ///< their numbers, in the order of their use
};

/// An accessor that holds a value for each vertex of a primitive.
struct AttributeSource {
    std::string name; ///< for errors
    int accessor = 0;
    std::vector<int> types; ///< TINYGLTF_TYPE_ that glTF allows
};

/// Returns the value of each vertex used, [V]; components that the accessor lacks are 1.  Throws
/// InputError, naming the primitive: a damaged accessor, a type that is not allowed, a count that
/// is not that of the vertices, a number that is not finite.
std::vector<glm::dvec4> read_vertex_values(const PrimitivePlace& at, const AttributeSource& from,
                                           const UsedVertices& used);

/// Reads the wanted attributes and the colours of the vertices used, in their order; arrays are
/// empty where the primitive has none.  Colours are clamped to 0 to 1, tangents left as they are.
/// Throws InputError as read_vertex_values does.
VertexAttributes read_attributes(const PrimitivePlace& at, const WantedAttributes& wanted,
                                 const UsedVertices& used);

} // namespace hipmap
