#pragma once

#include "common/scene/obj_text.h"
#include "common/scene/raw_scene.h"

#include <map>
#include <string>

namespace hipmap {

/// Reads the MTL files that an OBJ file names into `scene.materials`, by the table in
/// docs/scene.md. Returns the id of each material by its name.  Warns of what is not read, and of a
/// file that is missing or lies outside the scene's folder.
std::map<std::string, MaterialId> read_obj_materials(const ObjText& text, RawScene& scene);

/// Returns the material of a face without one: grey Lambert.
Material obj_default_material();

} // namespace hipmap
