#pragma once

#include "render/integrator/render_options.h"

namespace hipmap {

inline constexpr Integrator kAllIntegrators[] = {Integrator::path, Integrator::progressive,
                                                 Integrator::direct};

} // namespace hipmap
