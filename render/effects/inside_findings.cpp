// What light that gets into closed meshes does there.

#include "common/scene/scene_names.h"
#include "render/effects/effect_findings.h"
#include "render/media/material_insides.h"

namespace hipmap {

namespace {

/// Light is scattered beneath its surface.
bool scatters_inside(const Material& material, bool solid)
{
    return solid && material.boundary && lets_light_in(material) && !is_black(material.scattering);
}

} // namespace

Finding find_absorption(const SceneFacts& facts)
{
    const std::string names =
        facts.materials_where([](const Material& material, const Bsdf&, bool solid) {
            return solid && lets_light_in(material) && !is_black(material.absorption) &&
                   !material.holds_medium();
        });
    if (names.empty())
        return {false, "no solid glass has an attenuation colour", ""};
    return {true, names + " absorb light inside", "an exponential for each ray inside"};
}

Finding find_nested_dielectrics(const SceneFacts& facts)
{
    std::vector<std::string> names;
    for (std::size_t m = 0; m < facts.nested.size(); ++m)
        if (facts.nested[m] != 0)
            names.push_back(facts.scene.materials[m].name);
    if (names.empty())
        return {false, "no glass or liquid overlaps another", ""};
    return {true,
            list_names(names) + (names.size() == 1 ? " overlaps itself" : " overlap each other"),
            "a medium stack for each ray"};
}

Finding find_media(const SceneFacts& facts)
{
    const std::string names = facts.materials_where([](const Material& m, const Bsdf&, bool solid) {
        return !m.boundary ||
               (m.holds_medium() && solid && lets_light_in(m) && !scatters_inside(m, solid));
    });
    const bool around = !facts.scene.around.is_clear();
    if (names.empty() && !around)
        return {false, "no medium scatters or emits light", ""};
    const std::string inside = names.empty() ? "" : names + " contain a medium";
    const std::string grids =
        facts.materials_where([](const Material& m, const Bsdf&, bool) { return bool(m.density); });
    return {true,
            (around ? "a medium surrounds the scene" : "") +
                std::string(around && !names.empty() ? "; " : "") + inside +
                (grids.empty() ? "" : "; a grid gives the density of " + grids),
            grids.empty()
                ? "free paths along every ray, and photons in the media"
                : "free paths along every ray, cell by cell of the grid, and photons in the media"};
}

Finding find_subsurface(const SceneFacts& facts)
{
    const std::string names = facts.materials_where(
        [](const Material& m, const Bsdf&, bool solid) { return scatters_inside(m, solid); });
    if (names.empty()) {
        const std::string shut = facts.materials_where([](const Material& m, const Bsdf&, bool) {
            return m.boundary && !is_black(m.scattering);
        });
        return {false,
                shut.empty() ? "no material scatters light below its surface"
                             : "no light enters " + shut + ": opaque or not closed",
                ""};
    }
    return {true, names + " scatter light below their surface",
            "random walks of light paths and photons inside"};
}

} // namespace hipmap
