#pragma once

#include "common/scene/obj_text.h"
#include "common/scene/raw_scene.h"

#include <map>
#include <string>

namespace hipmap {

/// Reads the MTL files an OBJ file names into `scene.materials`, by the table in docs/scene.md;
/// the id of each by its name.  A file that is missing or lies outside the scene's folder, and
/// what is not read, is warned of.
std::map<std::string, MaterialId> read_obj_materials(const ObjText& text, RawScene& scene);

/// What a face without material gets: grey Lambert.
Material obj_default_material();

} // namespace hipmap
