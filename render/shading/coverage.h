#pragma once

#include "common/rays/embree_scene.h"
#include "common/scene/scene.h"

namespace hipmap {

/// Whether some point of the material may stop less than all light: by its alpha, its picture's or
/// the vertices'.  Never where it has no surface.  Cost: linear in the picture.
bool may_let_light_pass(const Scene& scene, const Material& material);

/// What each face stops, docs/light_transport.md (22): alpha, or 0 or 1 where it is a mask.  Empty
/// if no face lets light pass.  Borrows the scene.
Coverage coverage_of(const Scene& scene);

} // namespace hipmap
