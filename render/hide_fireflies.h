#pragma once

#include "render/film/fireflies.h"
#include "render/film/render_state.h"
#include "render/options.h"

namespace hipmap {

/// Removes the fireflies of the state's film if `choice` says so, as look_at_error has done by the
/// same choice; else finds them.  The state is then one to show, so write its file before.
ShownFireflies hide_fireflies(FireflyChoice choice, RenderState& state);

} // namespace hipmap
