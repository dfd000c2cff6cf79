#pragma once

#include "common/scene/raw_scene.h"

#include <span>
#include <string>

namespace hipmap {

/// Leaves out the faces of the objects that bear one of `names`, as their own or their mesh's
/// name, and the vertices that no other face uses; says so in the audit.
/// Throws InputError, listing similar names, if no object bears one of them.
void exclude_objects(RawScene& scene, std::span<const std::string> names);

} // namespace hipmap
