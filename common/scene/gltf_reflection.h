#pragma once

#include "common/scene/hipmap_extras.h"
#include "common/scene/raw_scene.h"

#include <nlohmann/json.hpp>

namespace hipmap {

/// Reads the reflection model of a material from its extras (docs/scene.md).  Properties that the
/// model does not use are reset, and the audit says so if the file has them.  from: the material's
/// JSON.  Throws InputError with the place: a value out of its range, a key of another model, a
/// missing key.
void read_reflection(HipmapExtras& extras, const nlohmann::json& from, Material& material,
                     SceneAudit& audit);

} // namespace hipmap
