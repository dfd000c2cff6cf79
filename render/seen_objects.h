#pragma once

#include "render/integrator/render_options.h"

#include <string>

namespace hipmap {

/// Names the objects that the camera sees by a grid of rays, those that most rays hit first.
std::string describe_seen(const RenderScene& scene, const RenderOptions& options);

/// Describes a light by its place in LightSet::lights: "point light 'Lamp'", "object 'Bulb'".
std::string describe_light(const RenderScene& scene, std::size_t light);

} // namespace hipmap
