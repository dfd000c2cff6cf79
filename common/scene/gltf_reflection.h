#pragma once

#include "common/scene/hipmap_extras.h"
#include "common/scene/raw_scene.h"

#include <nlohmann/json.hpp>

namespace hipmap {

/// The model by which a material reflects, from its extras (docs/scene.md).  What the model knows
/// nothing of is taken from the material, and the audit says so if the file has it.  from: the
/// material's JSON.  Throws InputError with the place: a value out of its range, a key of another
/// model, one that is missing.
void read_reflection(HipmapExtras& extras, const nlohmann::json& from, Material& material,
                     SceneAudit& audit);

} // namespace hipmap
