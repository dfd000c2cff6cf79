#pragma once

#include "common/scene/scene.h"
#include "experiments/rivals/rival.h"

#include <optional>

namespace hipmap {

/// A camera without a lens, as light paths see it.
struct Pinhole {
    const Camera* camera; ///< borrowed
    glm::vec2 size;       ///< of the image, pixels
    float half_height;    ///< of what is seen at distance 1
    float plane_distance; ///< of the image, in pixels, if they are squares of side 1
};

/// Returns the scene's camera; none: it is orthographic or has a lens.
std::optional<Pinhole> pinhole_of(const RenderScene& scene, const RivalSettings& settings);

/// A point as the camera sees it.
struct Projected {
    int x = 0, y = 0;      ///< pixel
    float cosine = 1.0f;   ///< between the ray and the axis of view
    float distance = 0.0f; ///< scene units
};

/// Projects a point; none: it is outside the image.
std::optional<Projected> project(const Pinhole& pinhole, const glm::vec3& point);

/// Returns the pdf per steradian of a ray through a random point of its pixel.
inline float pixel_pdf(const Pinhole& pinhole, float cosine)
{
    return pinhole.plane_distance * pinhole.plane_distance / (cosine * cosine * cosine);
}

} // namespace hipmap
