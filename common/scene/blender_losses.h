#pragma once

#include "common/scene/gltf_document.h"
#include "common/scene/gltf_nodes.h"
#include "common/scene/raw_scene.h"

#include <vector>

namespace hipmap {

/// Notes in the audit what Blender's exporter leaves out of a file without a word: objects of which
/// only an empty node remains (area lights, hair, geometry nodes), the size of lights, depth of
/// field, nodes that give a material its colour, and which objects are hidden: some by
/// their names.  Says what to do.  For a file that hipmap's add-on wrote or completed, it notes
/// only losses of materials.  nodes: of the default scene.  scene: read as far as lights and
/// cameras.
void note_blender_losses(const GltfDocument& document, const std::vector<PlacedNode>& nodes,
                         RawScene& scene);

} // namespace hipmap
