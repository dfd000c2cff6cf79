#pragma once

#include "render/film/image_error.h"
#include "render/integrator/render_options.h"

#include <optional>

namespace hipmap {

/// Bounds of the error by light that a run found and could not use, docs/error.md (23).
struct LostLight {
    double photons = 0;  ///< share of the image's light that dropped photons and cut paths carried
    double samples2 = 0; ///< relMSE by samples that were dropped
    double error2() const { return photons * photons + samples2; }
};

/// The light that an image may lack without its error showing it.
struct MissedLight {
    std::optional<UnseenLight> unseen; ///< nothing: photons were not counted
    LostLight lost;
};

/// Finds the light that the passes of a run missed.  pixels: of the image.
MissedLight find_missed_light(const RenderStatistics& statistics, PixelFilter filter,
                              std::size_t pixels);

/// Returns an error with the lost light in its interval.
ImageError with_lost_light(const ImageError& error, const LostLight& lost);

/// Returns whether unseen light may change the estimated error.  error: nothing: it is not known.
bool is_much(const UnseenLight& unseen, const std::optional<ImageError>& error);

/// Returns whether lost light may.
bool is_much(const LostLight& lost, const std::optional<ImageError>& error);

} // namespace hipmap
