#pragma once

#include "common/scene/gltf_document.h"

#include <tiny_gltf.h>

namespace hipmap {

/// Parses the checked document with tinygltf, loads its buffers and decodes compressed data
/// (KHR_draco_mesh_compression, EXT_meshopt_compression), so that accessors can be read alike for
/// any form of the file.  Materials and textures are left alone. Throws InputError: an unknown or
/// unreadable required extension, a buffer that is missing, too short, or not beside the scene
/// (absolute, "..", another scheme), damaged compressed data.
tinygltf::Model parse_gltf(GltfDocument& document);

} // namespace hipmap
