#pragma once

#include "render/effects/scene_facts.h"

#include <string>

namespace hipmap {

/// Says whether a scene needs an effect that the renderer has.
struct Finding {
    bool on = false;
    std::string reason; ///< a sentence about the scene, without a full stop
    std::string cost;   ///< if it is on, in words
};

// By light and camera.
Finding find_soft_shadows(const SceneFacts& facts);
Finding find_indirect(const SceneFacts& facts);
Finding find_caustics(const SceneFacts& facts);
Finding find_environment(const SceneFacts& facts);
Finding find_depth_of_field(const SceneFacts& facts);
Finding find_motion_blur(const SceneFacts& facts);

// By the materials that faces wear.
Finding find_mirror(const SceneFacts& facts);
Finding find_glossy(const SceneFacts& facts);
Finding find_refraction(const SceneFacts& facts);
Finding find_absorption(const SceneFacts& facts);
Finding find_dispersion(const SceneFacts& facts);
Finding find_nested_dielectrics(const SceneFacts& facts);
Finding find_media(const SceneFacts& facts);
Finding find_subsurface(const SceneFacts& facts);
Finding find_textures(const SceneFacts& facts);
Finding find_normal_maps(const SceneFacts& facts);
Finding find_vertex_colours(const SceneFacts& facts);
Finding find_alpha(const SceneFacts& facts);
Finding find_clearcoat(const SceneFacts& facts);
Finding find_sheen(const SceneFacts& facts);
Finding find_diffuse_transmission(const SceneFacts& facts);
Finding find_anisotropy(const SceneFacts& facts);
Finding find_reflection_models(const SceneFacts& facts);

} // namespace hipmap
