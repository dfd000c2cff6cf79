#pragma once

#include "render/film/fireflies.h"
#include "render/film/render_state.h"
#include "render/options.h"

namespace hipmap {

/// Finds the fireflies of the state's film.  Removes them if `choice` says so, and makes the last
/// check of the state tell the error of what is left: the state is then one to show, so write its
/// file before.
ShownFireflies hide_fireflies(FireflyChoice choice, RenderState& state);

} // namespace hipmap
