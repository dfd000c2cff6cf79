#pragma once

#include "render/lobes/lobe_view.h"

namespace hipmap {

/// Returns the view of a surface whose normal is z and whose tangent is x.  out: unit.
inline LobeView view_from(const glm::vec3& out)
{
    return {.normal = {0, 0, 1}, .out = out, .cosine = out.z, .tangent = {1, 0, 0}};
}

} // namespace hipmap
