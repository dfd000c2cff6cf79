#pragma once

#include "common/scene/raw_scene.h"

#include <tiny_gltf.h>

#include <string>

namespace hipmap {

/// Adds punctual light `index` of the file (KHR_lights_punctual), named `name`, as placed by a
/// node's `to_world`; the node's scale means nothing.  A light of an unknown kind is warned of and
/// not added; whether it is. Throws InputError, naming the light: negative intensity or colour,
/// cone angles out of range.
bool add_gltf_light(const tinygltf::Model& model, std::size_t index, const std::string& name,
                    const glm::dmat4& to_world, RawScene& scene);

/// Adds camera `index` of the file likewise.
/// Throws InputError, naming the camera: a field of view, size or clipping plane out of range.
bool add_gltf_camera(const tinygltf::Model& model, std::size_t index, const std::string& name,
                     const glm::dmat4& to_world, RawScene& scene);

} // namespace hipmap
