#include "common/rays/camera_ray.h"

#include <algorithm>

namespace hipmap {

Ray camera_ray(const Camera& camera, const glm::vec2& picture, float aspect, const glm::vec2& lens)
{
    // Half extents of the picture plane, at distance 1 (perspective) or in scene units
    // (orthographic).
    const float own_aspect = camera.aspect > 0 ? camera.aspect : aspect;
    float half_height =
        camera.projection == Projection::perspective ? camera.tan_half_height : camera.half_height;
    if (aspect < own_aspect)
        half_height *= own_aspect / aspect;
    const glm::vec2 plane(half_height * (aspect * (2 * picture.x - 1) + 2 * camera.shift.x),
                          half_height * (1 - 2 * picture.y + 2 * camera.shift.y));
    const glm::vec3 across = camera.right * plane.x + camera.up * plane.y;

    Ray ray;
    float per_forward = 1; // ray length for each unit along forward
    if (camera.projection == Projection::perspective) {
        glm::vec3 towards = camera.forward + across;
        ray.origin = camera.position;
        if (has_lens(camera)) { // all rays of a point meet in the plane in focus
            const glm::vec3 aside =
                camera.aperture_radius * (lens.x * camera.right + lens.y * camera.up);
            ray.origin += aside;
            towards -= aside / camera.focus_distance;
        }
        per_forward = glm::length(towards);
        ray.direction = towards / per_forward;
    } else {
        ray.origin = camera.position + across;
        ray.direction = camera.forward;
    }
    ray.near = std::max(ray.near, camera.near_clip * per_forward);
    if (camera.far_clip > 0)
        ray.far = camera.far_clip * per_forward;
    return ray;
}

} // namespace hipmap
