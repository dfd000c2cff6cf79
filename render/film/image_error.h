#pragma once

#include "render/film/film.h"

#include <optional>

namespace hipmap {

/// The error of an image: relMSE, docs/error.md (3), and its root.  1: 100 %.
struct ImageError {
    BiasKnowledge bias = BiasKnowledge::unknown;
    double noise2 = 0;   ///< relMSE that noise makes
    double photon2 = 0;  ///< the part of it that photons make, which falls more slowly
    double bias2 = 0;    ///< relMSE that bias makes, without bias itself: below zero now and then
    double clamp2 = 0;   ///< relMSE that clamping makes, not below zero; more passes keep it
    double removed2 = 0; ///< relMSE of the light of removed fireflies
    double missing2 = 0; ///< 95 % limit of the relMSE of light that passes missed, of `expected`
    double order = 0;    ///< bias falls with this power of the radius, 1 to 4; 0: not known
    double error = 0;    ///< root of noise2, clamp2 and removed2, and of bias2 where above zero
    double low = 0;      ///< with `high`, 95 % interval for the error of this very image
    double high = 0;     ///< infinite: not known, below kFewestBatches with passes
    bool operator==(const ImageError&) const = default;
};

/// Estimates the error of `film_image(film)`, from the differences between its batches and between
/// its radii. None if there are fewer than two passes.  With an unknown bias, it is the error of
/// the noise alone. Black images have error 0.  Parallel; the same at any thread count.
std::optional<ImageError> estimate_error(const Film& film);

/// The standard deviation and the signed bias by pixel and channel, both noisy; W/(m2 sr).
struct ErrorLayers {
    Image noise;
    Image bias;  ///< empty unless known from radii
    Image error; ///< root of the sum of both squares, the square of the bias being that of two
                 ///< halves multiplied and nothing below zero
};

ErrorLayers error_layers(const Film& film);

} // namespace hipmap
