#pragma once

#include "experiments/rivals/rival.h"

#include <span>

namespace hipmap {

/// A method to render by, beside those of hipmap.
struct RivalMethod {
    const char* name; ///< on the command line
    const char* help; ///< what it does and which options it reads, in a clause
    RivalImage (*render)(const RenderScene& scene, const RivalSettings& settings);
};

/// Returns all methods.
std::span<const RivalMethod> rival_methods();

/// Returns the method of a name.  Throws InputError, listing the names.
const RivalMethod& rival_method(const char* name);

} // namespace hipmap
