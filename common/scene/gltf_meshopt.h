#pragma once

#include "common/scene/gltf_document.h"

#include <tiny_gltf.h>

namespace hipmap {

/// Decodes every bufferView with EXT_meshopt_compression into its own buffer, and points the view
/// there.  Memory is bounded before it is allocated: the codec spends at least a byte on 64 bytes
/// of vertices, on a triangle, on an index, and compressed parts may not overlap. Throws
/// InputError, naming the view: a mode, filter or stride that the extension does not allow, damaged
/// data.
void decode_meshopt_views(const GltfDocument& document, tinygltf::Model& model);

} // namespace hipmap
