#pragma once

#include "common/rays/embree_scene.h"
#include "common/scene/scene.h"

namespace hipmap {

/// Returns the camera ray through a point of the image. picture: (0, 0) top left, (1, 1) bottom
/// right.  aspect: width over height of the image; if it differs from the camera's, the smaller
/// field of view is kept whole. near and far are the camera's clipping planes. lens: a point of the
/// unit disc, where the ray passes the lens of a camera that `has_lens`.
Ray camera_ray(const Camera& camera, const glm::vec2& picture, float aspect,
               const glm::vec2& lens = glm::vec2(0.0f));

/// Returns whether the camera has a lens of finite size, which blurs what is out of focus.
inline bool has_lens(const Camera& camera)
{
    return camera.projection == Projection::perspective && camera.aperture_radius > 0 &&
           camera.focus_distance > 0;
}

} // namespace hipmap
