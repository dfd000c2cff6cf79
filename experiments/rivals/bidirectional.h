#pragma once

#include "experiments/rivals/rival.h"

namespace hipmap {

/// Renders by bidirectional path tracing (Lafortune and Willems 1993; Veach and Guibas 1994): a
/// path from the eye and one from a light for each sample, joined at all their vertices, and
/// weighted by the balance heuristic (Veach and Guibas 1995).  Light paths that reach the camera
/// count too, if it is a pinhole.  Its lights are emissive faces and point lights.  Throws
/// InputError: other lights, media, opacity, or copies.
RivalImage render_bidirectional(const RenderScene& scene, const RivalSettings& settings);

} // namespace hipmap
