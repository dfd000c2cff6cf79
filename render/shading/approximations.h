#pragma once

#include "common/scene/scene.h"

#include <string>
#include <vector>

namespace hipmap {

/// Sentences that name the materials (of faces that exist) which are rendered otherwise than their
/// numbers say: rough reflections taken as diffuse, rough glass taken as smooth.  Empty: none.
std::vector<std::string> describe_approximations(const Scene& scene);

} // namespace hipmap
