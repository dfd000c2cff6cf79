#pragma once

#include "common/partition/partition.h"
#include "common/scene/scene.h"
#include "render/effects/light_classes.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace hipmap {

/// The effects that a scene may need, docs/effects.md.
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

/// Returns the name of an effect as the user writes it.
std::string_view name_of(Effect effect);

/// Returns whether --effects can leave an effect out.
bool can_be_left_out(Effect effect);

/// An effect to leave out, or to keep.
struct EffectSwitch {
    Effect effect = Effect::indirect;
    bool on = true;
};

/// Parses effect switches such as "-caustics,+textures".  Throws InputError, listing the names: an
/// unknown name, one without + or -, one that cannot be left out.
std::vector<EffectSwitch> parse_effect_switches(std::string_view text);

/// Formats switches as parse_effect_switches reads them: "-caustics,+textures".
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

/// A decision for every effect, in the order of the names.
struct EffectPlan {
    std::array<PlannedEffect, kEffects> effects;

    bool has(Effect effect) const { return effects[static_cast<std::size_t>(effect)].on; }
};

/// Decides which effects the scene needs: an effect is on only if some face, light or camera needs
/// it and the renderer has it.  Cost: as gather_facts.
EffectPlan plan_effects(const Scene& scene, const Partition& partition,
                        const EffectOptions& options);

/// Returns the classes of light that the plan traces.
LightClasses light_classes(const EffectPlan& plan);

/// Describes a planned effect: "caustics: on; specular surfaces send light to others: 'Glass';
/// costs
/// ...".
std::string describe(const PlannedEffect& effect);

/// Lists the names of the effects that are on: "indirect, caustics"; "none".
std::string list_effects(const EffectPlan& plan);

} // namespace hipmap
