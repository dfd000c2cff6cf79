#include "experiments/rivals/pinhole.h"

#include "common/rays/camera_ray.h"

#include <cmath>

namespace hipmap {

std::optional<Pinhole> pinhole_of(const RenderScene& scene, const RivalSettings& settings)
{
    const Camera& camera = scene.scene.cameras[scene.scene.camera];
    if (camera.projection != Projection::perspective || has_lens(camera))
        return std::nullopt;
    Pinhole out{&camera, glm::vec2(settings.width, settings.height), camera.tan_half_height, 0};
    const float aspect = out.size.x / out.size.y;
    if (camera.aspect > aspect) // as camera_ray keeps the smaller field of view
        out.half_height *= camera.aspect / aspect;
    out.plane_distance = out.size.y / (2 * out.half_height);
    return out;
}

std::optional<Projected> project(const Pinhole& pinhole, const glm::vec3& point)
{
    const Camera& camera = *pinhole.camera;
    const glm::vec3 way = point - camera.position;
    const float along = glm::dot(way, camera.forward);
    if (!(along > camera.near_clip) || (camera.far_clip > 0 && along > camera.far_clip))
        return std::nullopt;
    const glm::vec2 plane =
        glm::vec2(glm::dot(way, camera.right), glm::dot(way, camera.up)) / along;
    const glm::vec2 shift = 2.0f * pinhole.half_height * camera.shift;
    const glm::vec2 at =
        pinhole.plane_distance * (plane - shift) * glm::vec2(1, -1) + 0.5f * pinhole.size;
    Projected out{static_cast<int>(std::floor(at.x)), static_cast<int>(std::floor(at.y))};
    if (!(at.x >= 0 && at.y >= 0 && at.x < pinhole.size.x && at.y < pinhole.size.y))
        return std::nullopt;
    out.distance = glm::length(way);
    out.cosine = along / out.distance;
    return out;
}

} // namespace hipmap
