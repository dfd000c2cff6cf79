#include "render/hide_fireflies.h"

namespace hipmap {

ShownFireflies hide_fireflies(FireflyChoice choice, RenderState& state)
{
    ShownFireflies out;
    if (!state.checks.empty())
        out.kept = find_fireflies(state.film, state.checks.back().error);
    if (choice == FireflyChoice::keep)
        return out;
    out.removed = remove_fireflies(state.film);
    if (out.removed->pixels > 0)
        state.checks.back().error = *estimate_error(state.film, *out.removed);
    return out;
}

} // namespace hipmap
