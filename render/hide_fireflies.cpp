#include "render/hide_fireflies.h"

namespace hipmap {

ShownFireflies hide_fireflies(FireflyChoice choice, RenderState& state)
{
    ShownFireflies out;
    if (choice == FireflyChoice::remove)
        out.removed = remove_fireflies(state.film);
    else if (!state.checks.empty())
        out.kept = find_fireflies(state.film, state.checks.back().error);
    return out;
}

} // namespace hipmap
