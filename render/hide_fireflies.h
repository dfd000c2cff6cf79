#pragma once

#include "render/film/fireflies.h"
#include "render/film/render_state.h"
#include "render/options.h"

namespace hipmap {

/// Removes the fireflies of the state's film if `choice` says so, and makes its last check tell the
/// error of what is left.  The state is then one to show: write its file before.  Returns what was
/// removed; none if nothing was to be.
std::optional<RemovedFireflies> hide_fireflies(FireflyChoice choice, RenderState& state);

} // namespace hipmap
