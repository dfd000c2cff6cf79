#pragma once

#include "experiments/rivals/rival.h"

namespace hipmap {

/// Renders from a light field (Levoy and Hanrahan 1996): paths give the radiance between a grid of
/// cameras in a window about the scene's camera and a grid of points on a plane at the depth of the
/// scene; the image is interpolated between them in all four coordinates.  The camera itself lies
/// between those of the grid.  Throws InputError: a camera with a lens, or an orthographic one.
RivalImage render_light_field(const RenderScene& scene, const RivalSettings& settings);

} // namespace hipmap
