#pragma once

#include "common/scene/gltf_document.h"

#include <tiny_gltf.h>

namespace hipmap {

/// Parses the checked document with tinygltf and loads its buffers; pictures are left alone.
/// Afterwards every buffer holds exactly its byteLength.
/// Throws InputError: an unknown or unreadable required extension, a buffer that is missing, too
/// short, or not beside the scene (absolute, "..", another scheme).
tinygltf::Model parse_gltf(const GltfDocument& document);

} // namespace hipmap
