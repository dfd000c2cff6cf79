#pragma once

#include "common/scene/gltf_factors.h"
#include "common/scene/texture.h"

namespace hipmap {

/// The old way of glTF to describe a material: diffuse and specular colour and glossiness.
inline constexpr const char* kSpecularGlossiness = "KHR_materials_pbrSpecularGlossiness";

/// Returns whether a material is described so; its metallic-roughness part is then only a fallback.
bool is_specular_glossy(const nlohmann::json& material);

/// Sets base colour, alpha, roughness and reflection of a material from KHR_materials_
/// pbrSpecularGlossiness, as KHR_materials_specular says: not metallic, of an infinite index of
/// refraction, so that the specular colour is F0.
void read_specular_glossiness(const nlohmann::json& material, FactorReader& read, Material& out);

/// Returns the image of a roughness that a glossiness texture stands for: green is 1 - glossiness
/// times the texture's alpha.
TextureImage roughness_of_glossiness(const TextureImage& texture, float glossiness);

} // namespace hipmap
