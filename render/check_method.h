#pragma once

#include "render/integrator/render_options.h"

namespace hipmap {

/// Throws InputError if an option is not of the integrator asked for.
void check_method(const RenderOptions& render);

} // namespace hipmap
