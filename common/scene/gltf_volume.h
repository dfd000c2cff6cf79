#pragma once

#include "common/scene/gltf_factors.h"

namespace hipmap {

/// Reads the medium inside a material's closed meshes from KHR_materials_volume and
/// KHR_materials_volume_scatter; coefficients per metre, docs/media.md (13). Throws InputError: an
/// attenuation distance that is not above 0, an anisotropy that is not above -1 and below 1.
void read_volume(const nlohmann::json& material, FactorReader& read, Material& out);

} // namespace hipmap
