#pragma once

#include "common/scene/raw_scene.h"

#include <tiny_gltf.h>

#include <string>

namespace hipmap {

/// Luminous efficacy by which photometric units are turned into radiometric ones, lm/W.
inline constexpr double kLumensPerWatt = 683.0;

/// Adds punctual light `index` of the file (KHR_lights_punctual), named `name`, placed by a node's
/// `to_world`; the node's scale has no effect.  Returns whether it was added: a light of an unknown
/// kind is only warned of.  Throws InputError, naming the light: negative intensity or colour, cone
/// angles out of range.
bool add_gltf_light(const tinygltf::Model& model, std::size_t index, const std::string& name,
                    const glm::dmat4& to_world, RawScene& scene);

/// Adds camera `index` of the file, placed by a node's `to_world`.  Returns whether it was added.
/// Throws InputError, naming the camera: a field of view, size or clipping plane out of range.
bool add_gltf_camera(const tinygltf::Model& model, std::size_t index, const std::string& name,
                     const glm::dmat4& to_world, RawScene& scene);

} // namespace hipmap
