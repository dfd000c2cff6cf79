#pragma once

#include "render/layers/layer.h"

#include <span>

namespace hipmap {

/// Returns every layer that `render --layers` can write.
std::span<const LayerRow> layer_rows();

} // namespace hipmap
