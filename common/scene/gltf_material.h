#pragma once

#include "common/scene/gltf_document.h"
#include "common/scene/raw_scene.h"

#include <tiny_gltf.h>

namespace hipmap {

/// Reads the materials of a checked document into `scene.materials` (absorption per metre) and
/// their textures into `scene.images`, and notes in the audit what is assumed and what is lost.
/// Factors beyond their range are clamped and warned of.  Throws InputError, naming the material:
/// negative emission, an index of refraction below 1.
void read_gltf_materials(const GltfDocument& document, const tinygltf::Model& model,
                         RawScene& scene);

/// Returns the material that glTF 2.0 gives a primitive without one.
Material gltf_default_material(Look look);

} // namespace hipmap
