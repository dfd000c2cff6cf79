#pragma once

#include "common/scene/scene.h"

#include <string>
#include <vector>

namespace hipmap {

/// Sentences that name the materials (of faces that exist) with glossy reflections and rough glass,
/// and say what the roughness makes of them: followed by rays, or gathered from photons.  By the
/// factors alone: textures may make parts smoother.  Empty: none.
std::vector<std::string> describe_reflections(const Scene& scene);

} // namespace hipmap
