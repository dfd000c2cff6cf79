#include "render/effects/effect_plan.h"

#include "common/input_error.h"
#include "common/scene/scene_names.h"
#include "render/effects/effect_findings.h"

#include <algorithm>

namespace hipmap {

namespace {

struct Row {
    Effect effect;
    const char* name;
    Finding (*find)(const SceneFacts& facts);
    bool can_be_left_out; ///< by LightClasses or drop_effects
};

constexpr std::array<Row, kEffects> kRows = {{
    {Effect::soft_shadows, "soft-shadows", find_soft_shadows, false},
    {Effect::indirect, "indirect", find_indirect, true},
    {Effect::mirror, "mirror", find_mirror, false},
    {Effect::glossy, "glossy", find_glossy, false},
    {Effect::refraction, "refraction", find_refraction, false},
    {Effect::caustics, "caustics", find_caustics, true},
    {Effect::absorption, "absorption", find_absorption, true},
    {Effect::dispersion, "dispersion", find_dispersion, true},
    {Effect::nested_dielectrics, "nested-dielectrics", find_nested_dielectrics, true},
    {Effect::media, "media", find_media, true},
    {Effect::subsurface, "subsurface", find_subsurface, true},
    {Effect::textures, "textures", find_textures, true},
    {Effect::normal_maps, "normal-maps", find_normal_maps, true},
    {Effect::vertex_colours, "vertex-colours", find_vertex_colours, true},
    {Effect::alpha, "alpha", find_alpha, true},
    {Effect::clearcoat, "clearcoat", find_clearcoat, true},
    {Effect::sheen, "sheen", find_sheen, true},
    {Effect::diffuse_transmission, "diffuse-transmission", find_diffuse_transmission, true},
    {Effect::anisotropy, "anisotropy", find_anisotropy, true},
    {Effect::reflection_models, "reflection-models", find_reflection_models, true},
    {Effect::environment, "environment", find_environment, true},
    {Effect::depth_of_field, "depth-of-field", find_depth_of_field, true},
    {Effect::motion_blur, "motion-blur", find_motion_blur, true},
}};

std::string names_that_can_be_left_out()
{
    std::string out;
    for (const Row& row : kRows)
        if (row.can_be_left_out)
            out += (out.empty() ? "" : ", ") + std::string(row.name);
    return out;
}

EffectSwitch parse_switch(std::string_view word)
{
    const auto fail = [&](const char* what) {
        return InputError("--effects " + quote_name(word) + ": " + what +
                          "; write -NAME or +NAME, where NAME is one of " +
                          names_that_can_be_left_out());
    };
    if (word.empty() || (word[0] != '-' && word[0] != '+'))
        throw fail("does not begin with + or -");
    const auto row = std::find_if(kRows.begin(), kRows.end(),
                                  [&](const Row& r) { return word.substr(1) == r.name; });
    if (row == kRows.end())
        throw fail("no such effect");
    if (!row->can_be_left_out)
        throw fail("this effect cannot be left out");
    return {row->effect, word[0] == '+'};
}

bool is_switched_off(Effect effect, const std::vector<EffectSwitch>& switches)
{
    const auto last = std::find_if(switches.rbegin(), switches.rend(),
                                   [&](const EffectSwitch& s) { return s.effect == effect; });
    return last != switches.rend() && !last->on;
}

PlannedEffect plan_effect(const Row& row, const SceneFacts& facts, const EffectOptions& options)
{
    const Finding found = row.find(facts);
    const bool by_bounces = row.effect == Effect::indirect || row.effect == Effect::caustics ||
                            row.effect == Effect::media || row.effect == Effect::subsurface;
    PlannedEffect out{row.effect, found.on, found.reason, found.on ? found.cost : ""};
    if (found.on && by_bounces && !options.bounces)
        out = {row.effect, false, "--maps none stores no photons for it, though " + found.reason,
               ""};
    if (found.on && is_switched_off(row.effect, options.switches))
        out = {row.effect, false, "left out by --effects, though " + found.reason, ""};
    return out;
}

} // namespace

std::string_view name_of(Effect effect)
{
    return kRows[static_cast<std::size_t>(effect)].name;
}

bool can_be_left_out(Effect effect)
{
    return kRows[static_cast<std::size_t>(effect)].can_be_left_out;
}

std::string text_of(const std::vector<EffectSwitch>& switches)
{
    std::string out;
    for (const EffectSwitch& one : switches)
        out.append(out.empty() ? "" : ",").append(one.on ? "+" : "-").append(name_of(one.effect));
    return out;
}

std::vector<EffectSwitch> parse_effect_switches(std::string_view text)
{
    std::vector<EffectSwitch> out;
    while (true) {
        const std::size_t comma = std::min(text.find(','), text.size());
        out.push_back(parse_switch(text.substr(0, comma)));
        if (comma == text.size())
            return out;
        text.remove_prefix(comma + 1);
    }
}

EffectPlan plan_effects(const Scene& scene, const Partition& partition,
                        const EffectOptions& options)
{
    SceneFacts facts = gather_facts(scene, partition);
    facts.shutter = options.shutter;
    facts.moving = options.moving;
    EffectPlan plan;
    for (std::size_t i = 0; i < kEffects; ++i)
        plan.effects[i] = plan_effect(kRows[i], facts, options);
    return plan;
}

LightClasses light_classes(const EffectPlan& plan)
{
    return {plan.has(Effect::caustics), plan.has(Effect::indirect)};
}

std::string describe(const PlannedEffect& effect)
{
    std::string out(name_of(effect.effect));
    out += (effect.on ? ": on; " : ": off; ") + effect.reason;
    return effect.cost.empty() ? out : out + "; costs " + effect.cost;
}

std::string list_effects(const EffectPlan& plan)
{
    std::string out;
    for (const PlannedEffect& effect : plan.effects)
        if (effect.on)
            out.append(out.empty() ? "" : ", ").append(name_of(effect.effect));
    return out.empty() ? "none" : out;
}

} // namespace hipmap
