#pragma once

#include "render/film/image_error.h"

namespace hipmap {

/// Few pixels that carry much of the estimated error, each mostly by one rare bright sample.
struct Fireflies {
    std::uint64_t pixels = 0;
    double share = 0;         ///< of the square of the estimated error
    double error_without = 0; ///< estimated, of the other pixels

    bool operator==(const Fireflies&) const = default;
};

/// Returns the fireflies of a film by docs/error.md (19); none: no such pixels, or they carry less
/// than a quarter of the square of the error.  error: estimate_error(film).  Costs about as much as
/// that.
std::optional<Fireflies> find_fireflies(const Film& film, const ImageError& error);

} // namespace hipmap
