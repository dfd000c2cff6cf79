#pragma once

#include "common/math/random.h"
#include "render/shading/render_scene.h"

#include <vector>

namespace hipmap {

/// The probabilities with which bidirectional path tracing starts light paths.
struct LightStarts {
    std::vector<double> cumulative; ///< [lights] by power, ends at 1
    std::vector<float> face_pdf;    ///< [F] per area of an emissive face, over all lights; else 0
};

/// Plans them.  Throws InputError: a light that is neither a point nor emissive faces.
LightStarts plan_starts(const RenderScene& scene);

/// The start of a light path.
struct LightStart {
    Ray ray;
    Rgb power{0.0f};       ///< over the probability of its light
    float pdf = 0.0f;      ///< per area (of a face alone) and steradian
    float cosine = 1.0f;   ///< of the ray to the face
    bool is_point = false; ///< the light has no size
    SurfacePoint on_face;  ///< where it starts, if not
};

LightStart draw_start(const RenderScene& scene, const LightStarts& starts, RandomSequence& random);

/// Returns the probability with which paths start at a light.
inline float probability_of(const LightStarts& starts, std::size_t light)
{
    return static_cast<float>(starts.cumulative[light] -
                              (light == 0 ? 0.0 : starts.cumulative[light - 1]));
}

/// Returns the pdf per area and steradian with which paths start at a face in a direction.
/// cosine: of that to the face, above zero.
float start_pdf(const RenderScene& scene, const LightStarts& starts, FaceId face, float cosine);

} // namespace hipmap
