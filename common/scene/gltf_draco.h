#pragma once

#include "common/scene/gltf_document.h"

#include <tiny_gltf.h>

namespace hipmap {

/// Decodes every primitive with KHR_draco_mesh_compression and points its accessors to the decoded
/// data.  Uncompressed positions and indices in the file are used as they are. Throws InputError,
/// naming the primitive: damaged data, an attribute the data lacks, a count that is not its
/// accessor's.
void decode_draco_primitives(const GltfDocument& document, tinygltf::Model& model);

} // namespace hipmap
