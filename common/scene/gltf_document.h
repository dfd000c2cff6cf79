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
    std::vector<std::byte> bytes; ///< the whole file
    bool binary = false;          ///< GLB container
    nlohmann::json json;
};

/// Reads the file and parses its JSON, at most kDeepestJson levels deep.
/// Throws InputError: cannot be read, damaged container, not JSON, not glTF 2.x.
GltfDocument read_gltf_document(const std::filesystem::path& path);

/// Checks the type of every property that is read, every reference between parts of the file and
/// every bufferView's range, so that what follows may rely on them.  Throws InputError with the
/// place, as "meshes[3].primitives[0].indices".
void check_gltf_schema(const GltfDocument& document);

} // namespace hipmap
