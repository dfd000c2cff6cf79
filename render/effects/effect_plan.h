#pragma once

#include "common/partition/partition.h"
#include "common/scene/scene.h"
#include "render/effects/light_classes.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace hipmap {

/// What a scene may call for, docs/effects.md.
enum class Effect : std::uint8_t {
    soft_shadows,
    indirect,
    mirror,
    glossy,
    refraction,
    caustics,
    absorption,
    dispersion,
    nested_dielectrics,
    media,
    subsurface,
    textures,
    normal_maps,
    vertex_colours,
    alpha,
    clearcoat,
    sheen,
    diffuse_transmission,
    anisotropy,
    reflection_models,
    environment,
    depth_of_field,
    motion_blur,
};
inline constexpr std::size_t kEffects = 23;

/// As the user writes it.
std::string_view name_of(Effect effect);

/// An effect to be left out, or not to be.
struct EffectSwitch {
    Effect effect = Effect::indirect;
    bool on = true;
};

/// "-caustics,+textures".  Throws InputError, with the names there are: an unknown name, one
/// without + or -, one that cannot be left out.
std::vector<EffectSwitch> parse_effect_switches(std::string_view text);

/// What parse_effect_switches reads: "-caustics,+textures".
std::string text_of(const std::vector<EffectSwitch>& switches);

/// What the plan depends on besides the scene.
struct EffectOptions {
    std::vector<EffectSwitch> switches; ///< later ones win
    bool bounces = true;  ///< false: nothing finds light that comes by more than one surface
    bool shutter = false; ///< it is open for a time
    std::vector<std::string> moving{}; ///< names of what moves meanwhile
};

struct PlannedEffect {
    Effect effect = Effect::indirect;
    bool on = false;
    std::string reason; ///< a sentence about this scene
    std::string cost;   ///< in words; empty if off
};

/// Every effect, in the order of the names.
struct EffectPlan {
    std::array<PlannedEffect, kEffects> effects;

    bool has(Effect effect) const { return effects[static_cast<std::size_t>(effect)].on; }
};

/// What the scene calls for: an effect is on only if some face, light or camera needs it and the
/// renderer has it.  Cost: as gather_facts.
EffectPlan plan_effects(const Scene& scene, const Partition& partition,
                        const EffectOptions& options);

/// The light that the plan has followed.
LightClasses light_classes(const EffectPlan& plan);

/// "caustics: on; light reaches diffuse surfaces by way of 'Glass'; costs ...".
std::string describe(const PlannedEffect& effect);

/// The names of those that are on: "indirect, caustics"; "none".
std::string list_effects(const EffectPlan& plan);

} // namespace hipmap
