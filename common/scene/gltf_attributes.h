#pragma once

#include "common/scene/gltf_document.h"
#include "common/scene/mesh.h"

#include <tiny_gltf.h>

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

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

/// Reads the wanted attributes and the colours of the vertices `used`, in their order; arrays are
/// empty where the primitive has none.  Colours are clamped to 0 to 1, tangents left as they are.
/// vertex_count: of the primitive's positions.  Throws InputError, naming the primitive: damaged
/// accessors, a type that glTF does not allow, a count that is not vertex_count, a number that is
/// not finite.
VertexAttributes read_attributes(const PrimitivePlace& at, const WantedAttributes& wanted,
                                 std::size_t vertex_count, std::span<const std::uint32_t> used);

} // namespace hipmap
