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

/// What the removal of fireflies took from an image.
struct RemovedFireflies {
    std::uint64_t pixels = 0;
    double light = 0; ///< share of the sum of all channels that they carried
    double bias2 = 0; ///< relMSE of the light that is missing now, docs/error.md (24)
};

/// Takes the batches that hold fireflies out of their pixels, as if their passes had kept no sample
/// there, docs/error.md (24).  What two batches or more have found is no firefly and stays.  A film
/// with passes in fewer than kFewestBatches batches loses nothing.  The film is then one to show:
/// write its state before.  Costs about as much as find_fireflies.
RemovedFireflies remove_fireflies(Film& film);

/// The fireflies of an image to show.
struct ShownFireflies {
    std::optional<Fireflies> kept;
    std::optional<RemovedFireflies> removed; ///< none: they were to be kept
};

/// Returns the error of the film that is left, as estimate_error does, with that of the light that
/// is missing.
std::optional<ImageError> estimate_error(const Film& film, const RemovedFireflies& removed);

} // namespace hipmap
