#pragma once

#include "common/scene/gltf_document.h"
#include "common/scene/gltf_nodes.h"
#include "common/scene/raw_scene.h"

namespace hipmap {

/// What glTF lacks, from the extras `hipmap` (docs/scene.md has the keys).  All of them throw
/// InputError with the place if a value makes no sense, and warn of keys that are not known.

/// The size of the light that was added last, from a node and the light it bears.
void read_light_extras(const GltfDocument& document, std::size_t node, std::size_t light,
                       RawScene& scene);
/// The lens of the camera that was added last, from a node and the camera it bears.
void read_camera_extras(const GltfDocument& document, std::size_t node, std::size_t camera,
                        RawScene& scene);
/// An area light where a node that bears nothing stands (as Blender exports area lights).
void read_empty_extras(const GltfDocument& document, const PlacedNode& at, RawScene& scene);
/// The world, from the scene's extras.
void read_world_extras(const GltfDocument& document, RawScene& scene);
/// The inside of a material, per metre, whether it has a surface, and how that reflects.
void read_material_extras(const nlohmann::json& from, Material& material, RawScene& scene);

} // namespace hipmap
