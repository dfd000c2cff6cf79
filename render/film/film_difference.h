#pragma once

#include "render/film/film.h"

namespace hipmap {

/// How far apart two images are but for their noise, docs/error.md (20).
struct FilmDifference {
    double square = 0; ///< relMSE, without noise: below zero now and then
    double spread = 0; ///< standard deviation of `square`; infinite: not known
};

/// Estimates the difference between the images that two films of the same pixels and passes,
/// without parts, tend to, relative to the first one.  Passes of the same number may share their
/// random numbers.  With fewer than two batches it is zero, with fewer than three the spread is
/// infinite. Cost: as batch_products.  Thread-safe.
FilmDifference difference_of(const Film& film, const Film& other);

} // namespace hipmap
