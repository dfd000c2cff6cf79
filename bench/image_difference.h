#pragma once

#include "common/image/image.h"

#include <glm/glm.hpp>

namespace hipmap {

/// Mean of every channel over all pixels, in double.  An image without pixels: zero.
glm::dvec3 mean_radiance(const Image& image);

/// Relative mean squared error of `image` against `reference`:
///     mean over pixels and channels of (x - r)^2 / (r^2 + (0.1 m)^2),
/// m the mean of all channels of the reference, so that exposure does not matter.  Zero where both
/// are black.  Infinity where only the reference is.  The images have the same size.
double relative_mse(const Image& image, const Image& reference);

/// `left` beside `right`, of the same height.
Image side_by_side(const Image& left, const Image& right);

} // namespace hipmap
