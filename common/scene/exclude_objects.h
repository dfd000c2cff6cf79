#pragma once

#include "common/scene/raw_scene.h"

#include <span>
#include <string>

namespace hipmap {

/// Removes the faces of the objects called one of `names` (object or mesh name) and the vertices
/// that no other face uses; notes it in the audit. Throws InputError, listing similar names, if no
/// object has one of the names.
void exclude_objects(RawScene& scene, std::span<const std::string> names);

} // namespace hipmap
