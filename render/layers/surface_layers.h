#pragma once

#include "render/integrator/render_options.h"
#include "render/layers/layer.h"

#include <span>

namespace hipmap {

/// Returns those of the layers that show the first surfaces that the camera sees, in the order
/// given: a function of the scene and of size, crop, pixel filter and seed alone, at any number of
/// threads.  A surface that lets a share of light pass is skipped with that probability, decided
/// for each ray as for eye paths; mirrors and glass are seen themselves, media are not.  Moving
/// objects are where `scene` has them, without blur.  Casts a ray for each pixel, and 16 more if a
/// layer averages.
std::vector<LayerImage> surface_layers(const RenderScene& scene, const RenderOptions& options,
                                       std::span<const LayerRow* const> layers);

} // namespace hipmap
