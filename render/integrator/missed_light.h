#pragma once

#include "render/film/image_error.h"
#include "render/integrator/render_options.h"

#include <optional>

namespace hipmap {

/// The light that an image may lack without its error showing it.
struct MissedLight {
    std::optional<UnseenLight> unseen; ///< nothing: photons were not counted
};

/// Finds the light that the passes of a run missed.
MissedLight find_missed_light(const RenderStatistics& statistics);

/// Returns whether unseen light may change the estimated error.  error: nothing: it is not known.
bool is_much(const UnseenLight& unseen, const std::optional<ImageError>& error);

} // namespace hipmap
