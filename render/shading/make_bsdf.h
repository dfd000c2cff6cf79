#pragma once

#include "common/scene/light_path_rules.h"
#include "common/scene/scene.h"
#include "render/lobes/bsdf.h"
#include "render/shading/textured_material.h"

#include <vector>

namespace hipmap {

/// Up to this roughness a reflection is a mirror's and glass is clear: the lobe is narrower than a
/// pixel.
inline constexpr float kMirrorRoughness = 0.02f;

/// The least index ratio of rough glass: with exactly the index of its surroundings it would have
/// no surface.
inline constexpr float kLeastRoughIndex = 1.001f;

/// Returns the GGX width of facets; 0: a mirror.
inline float alpha_of(float roughness)
{
    return roughness > kMirrorRoughness ? roughness * roughness : 0;
}

/// Returns how an opaque reflection of this roughness is handled.
inline Lobes handled_at(float roughness)
{
    if (alpha_of(roughness) == 0)
        return Lobes::specular;
    return roughness <= kFollowedRoughness ? Lobes::followed : Lobes::gathered;
}

/// Makes the lobes and layers of a material at a point.  A material without a boundary has none.
Bsdf make_bsdf(const Material& material, const MaterialPoint& at);

/// Makes the lobes and layers of each material of the scene, [M], from its factors alone.
std::vector<Bsdf> make_bsdfs(const std::vector<Material>& materials);

} // namespace hipmap
