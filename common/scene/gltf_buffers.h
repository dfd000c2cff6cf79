#pragma once

#include "common/scene/gltf_document.h"

#include <string>
#include <vector>

namespace hipmap {

/// Returns the bytes a uri stands for: base64 text in the uri itself, or a file beside the scene.
/// Throws InputError naming `place`: damaged text, a file that is not beside the scene (absolute,
/// "..", another scheme) or cannot be read.
std::vector<unsigned char> read_gltf_uri(const GltfDocument& document, const std::string& place,
                                         const std::string& uri);

/// Returns the bytes of every buffer of a checked document, exactly byteLength of each.  A fallback
/// buffer of EXT_meshopt_compression that is not in the file is empty. The document's BIN chunk
/// becomes a buffer. Throws InputError, naming
/// the buffer: missing, too short, or as read_gltf_uri.
std::vector<std::vector<unsigned char>> load_gltf_buffers(GltfDocument& document);

} // namespace hipmap
