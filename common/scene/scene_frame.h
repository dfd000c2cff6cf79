#pragma once

#include "common/scene/raw_scene.h"

namespace hipmap {

/// Moves a raw scene into scene units: chooses the frame from the faces' bounding box and converts
/// everything to float, with materials, lights, cameras and the world. The unit is larger than the
/// longest side of the box only where a light or camera lies more than 2^50 sides away, so that all
/// of it fits into float. Throws InputError, naming the element, if a number is not finite, there
/// is no face at all, or there are more than 2^32 - 2 faces or vertices.  Empties the arrays of
/// `raw` as it goes.
Scene to_scene_units(RawScene& raw);

} // namespace hipmap
