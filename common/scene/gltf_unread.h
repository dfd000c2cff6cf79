#pragma once

#include "common/scene/gltf_document.h"
#include "common/scene/raw_scene.h"

namespace hipmap {

/// Throws InputError, with the cure where there is one, if the shapes or lights of the file need an
/// extension that hipmap does not read.
void check_required_extensions(const GltfDocument& document);

/// Adds one warning to the audit for each kind of thing that is in the file but not read, with the
/// names of what it concerns.
void warn_of_unread_gltf(const GltfDocument& document, SceneAudit& audit);

} // namespace hipmap
