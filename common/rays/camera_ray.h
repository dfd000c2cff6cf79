#pragma once

#include "common/rays/embree_scene.h"
#include "common/scene/scene.h"

namespace hipmap {

/// The ray through a point of the picture.
/// picture: (0, 0) top left, (1, 1) bottom right.  aspect: width over height of the picture; where
/// it is not the camera's own, the smaller of both fields of view is kept whole. near and far are
/// the camera's clipping planes.
Ray camera_ray(const Camera& camera, const glm::vec2& picture, float aspect);

} // namespace hipmap
