#pragma once

#include "common/image/image.h"
#include "common/rays/camera_ray.h"

#include <functional>

namespace hipmap {

/// What the camera sees at one point of the image.
struct SeenPoint {
    FaceId face = kNone;
    glm::vec3 position{0.0f};  ///< scene units
    glm::vec3 direction{0.0f}; ///< unit, away from the camera
    float pixel = 0.0f;        ///< width of a pixel at this distance, scene units
};

/// Returns the display-linear colour of a point, before shading.  Called from many threads at once.
using Painter = std::function<Rgb(const SeenPoint&)>;

/// The view of an image to be painted: both dimensions in pixels, at least one.
struct PictureView {
    const TriangleMesh& mesh;
    const EmbreeScene& rays;
    const Camera& camera;
    int width;
    int height;
};

/// Paints the faces as the camera sees them, lit from the camera on both sides, with 4x4 samples a
/// pixel and a neutral grey where there is no face.  Returns one image for each painter, from the
/// same rays; display values (sRGB) in [0, 1].  Parallel; the same at any thread count.
std::vector<Image> colour_images(const PictureView& view, const std::vector<Painter>& painters);

} // namespace hipmap
