#pragma once

#include "common/rays/embree_scene.h"
#include "common/scene/scene.h"

namespace hipmap {

/// Returns whether some point of the material may stop less than all light: by its alpha, its
/// texture's or the vertices'.  False where it has no surface.  Cost: linear in the texture.
bool may_let_light_pass(const Scene& scene, const Material& material);

/// Returns the opacity of each face, docs/light_transport.md (22): alpha, or 0 or 1 where it is a
/// mask.  Empty if no face lets light pass.  Borrows the scene.
Opacity opacity_of(const Scene& scene);

} // namespace hipmap
