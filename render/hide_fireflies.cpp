#include "render/hide_fireflies.h"

namespace hipmap {

std::optional<RemovedFireflies> hide_fireflies(FireflyChoice choice, RenderState& state)
{
    if (choice == FireflyChoice::keep)
        return std::nullopt;
    RemovedFireflies out = remove_fireflies(state.film);
    if (out.pixels > 0)
        state.checks.back().error = *estimate_error(state.film, out);
    return out;
}

} // namespace hipmap
