#pragma once

#include "common/scene/gltf_document.h"
#include "common/scene/gltf_nodes.h"
#include "common/scene/raw_scene.h"

namespace hipmap {

/// Readers of the extras `hipmap`, which hold what glTF lacks (docs/scene.md lists the keys).  All
/// of them throw InputError with the place if a value makes no sense, and warn of unknown keys.

/// Reads the size of the light that was added last, from its node and light `light` of the file.
void read_light_extras(const GltfDocument& document, const PlacedNode& at, std::size_t light,
                       RawScene& scene);
/// Reads the lens of the camera that was added last, from a node and its camera.
void read_camera_extras(const GltfDocument& document, std::size_t node, std::size_t camera,
                        RawScene& scene);
/// Adds an area light at an empty node (Blender exports area lights as empty nodes).
void read_empty_extras(const GltfDocument& document, const PlacedNode& at, RawScene& scene);
/// Reads the world from the scene's extras.
void read_world_extras(const GltfDocument& document, RawScene& scene);
/// Reads the medium inside a material, per metre, whether the material has a surface, and its
/// reflection model.
void read_material_extras(const nlohmann::json& from, Material& material, RawScene& scene);

} // namespace hipmap
