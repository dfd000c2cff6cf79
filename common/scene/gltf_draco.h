#pragma once

#include "common/scene/gltf_document.h"

#include <tiny_gltf.h>

namespace hipmap {

/// Gives every primitive with KHR_draco_mesh_compression accessors over decoded data.  Where the
/// file has its positions and indices uncompressed too, those are taken as they are.
/// Throws InputError, naming the primitive: damaged data, an attribute the data lacks, a count that
/// is not its accessor's.
void decode_draco_primitives(const GltfDocument& document, tinygltf::Model& model);

} // namespace hipmap
