#pragma once

#include "common/partition/partition.h"
#include "common/scene/scene.h"

#include <filesystem>

namespace hipmap {

/// Writes a binary glTF 2.0 file with the scene's faces in the colours of their shared maps (as in
/// shared_maps.png) as vertex colours, faces without a map grey.  One node and mesh per object that
/// has faces, with its name; in metres, in the place of the scene's faces; a single white material.
/// Every face has its own vertices.  Throws InputError if the file cannot be written or would
/// exceed the 4 GiB of the format.  Linear.
void write_coloured_glb(const std::filesystem::path& path, const Scene& scene,
                        const Partition& partition);

} // namespace hipmap
