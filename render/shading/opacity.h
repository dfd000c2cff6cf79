#pragma once

#include "common/rays/embree_scene.h"
#include "common/scene/scene.h"

namespace hipmap {

/// Whether some point of the material may stop less than all light: by its alpha, its texture's or
/// the vertices'.  Never where it has no surface.  Cost: linear in the texture.
bool may_let_light_pass(const Scene& scene, const Material& material);

/// What each face stops, docs/light_transport.md (22): alpha, or 0 or 1 where it is a mask.  Empty
/// if no face lets light pass.  Borrows the scene.
Opacity opacity_of(const Scene& scene);

} // namespace hipmap
