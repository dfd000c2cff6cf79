#pragma once

#include "common/scene/raw_scene.h"

#include <filesystem>
#include <optional>

namespace hipmap {

/// Reads a .gltf or .glb file: the default scene's nodes with all their instances.
/// Faces come in the order of a depth-first walk, so the same file gives the same faces.
/// time: of the animation, s; none: its nodes as they stand in the file.
/// Throws InputError with the place and what is wrong.
RawScene read_gltf(const std::filesystem::path& path, std::optional<double> time = {});

} // namespace hipmap
