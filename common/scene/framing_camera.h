#pragma once

#include "common/scene/scene.h"

namespace hipmap {

/// Makes a camera for a scene without one: a three-quarter view from slightly above that has every
/// vertex in view.  It stands at the front (+Z), or where an open surface such as a room without
/// one wall shows most of its fronts; its name says where.  Aspect 1.  Linear in the mesh.
Camera framing_camera(const TriangleMesh& mesh);

} // namespace hipmap
