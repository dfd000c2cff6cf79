#pragma once

#include "render/integrator/render_options.h"

#include <string>

namespace hipmap {

/// Says in a few words what the camera looks at: the objects that a grid of rays meets first, those
/// that most meet first.
std::string describe_seen(const RenderScene& scene, const RenderOptions& options);

} // namespace hipmap
