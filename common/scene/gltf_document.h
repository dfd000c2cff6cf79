#pragma once

#include <nlohmann/json.hpp>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace hipmap {

/// A .gltf or .glb file and its JSON, checked as far as JSON can be: see check_gltf_schema.
struct GltfDocument {
    std::filesystem::path path;
    bool binary = false;            ///< GLB container
    std::vector<unsigned char> bin; ///< the BIN chunk of a container, until load_gltf_buffers
    nlohmann::json json;
};

/// Returns the name of the program that wrote the file; empty if it says none.
std::string generator_of(const GltfDocument& document);

/// Returns whether a material, texture, node or buffer has an extension.
inline bool has_extension(const nlohmann::json& thing, const char* name)
{
    const auto extensions = thing.find("extensions");
    return extensions != thing.end() && extensions->contains(name);
}

/// Reads the file and parses its JSON, at most kDeepestJson levels deep.
/// Throws InputError: cannot be read, damaged container, not JSON, not glTF 2.x, or as
/// check_gltf_schema.
GltfDocument read_gltf_document(const std::filesystem::path& path);

/// Checks the type of every property that is read, every reference between parts of the file and
/// every bufferView's range, so that later code may rely on them.  Throws InputError with the
/// place, such as "meshes[3].primitives[0].indices".
void check_gltf_schema(const GltfDocument& document);

} // namespace hipmap
