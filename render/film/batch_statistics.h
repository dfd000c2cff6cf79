#pragma once

#include "render/film/batch_products.h"

namespace hipmap {

/// The 97.5 % quantile of the normal distribution, for a two-sided 95 % confidence interval.
inline constexpr double kZ = 1.959964;

struct Interval {
    double low = 0;
    double high = 0;
};

/// The covariance of one pass over all channels, by its traces.
struct Spread {
    double energy = 0; ///< trace: variance of a pass summed over the channels
    double square = 0; ///< trace of the square
    double freedom() const { return square > 0 ? energy * energy / square : 1; }
    /// Returns the variance in a direction, averaged over the directions in which there is noise.
    double along() const { return energy > 0 ? square / energy : 0; }
};

/// Estimates the covariance of one pass, docs/error.md (6).  centred: products of the differences
/// of batch means from the mean of all, times sqrt(passes).  With two batches or fewer, all
/// channels count as fully correlated.
Spread spread_of(const Products& centred, double channels);

/// Converts products of fields into the centred products that `spread_of` takes.
Products centred(const Products& products, const Batches& batches);

/// Returns the number of pairs of passes in different batches.
double pairs_of(const Batches& batches);

/// Returns the product of the expectations of two fields: the mean over pairs of passes from
/// different batches, whose noise is independent; docs/error.md (8).  At least two batches.
double product_of_means(const Products& products, const Batches& batches);

/// Returns the quantile of Fisher's F(above, below) at the probability that a normal variable is
/// below `z`; docs/error.md (7).  May be infinite.
double f_quantile(double z, double above, double below);

/// The sum of squares of the bias over the channels.
struct BiasSquare {
    double value = 0;
    double order = 0;  ///< power of the radius by which it falls, docs/error.md (12)
    double photon = 0; ///< variance that photons make in a pass, summed over the channels
    Interval interval; ///< 95 %, not cut at zero
};

/// Estimates the squared bias, docs/error.md (8) to (10).  Unknown with fewer than two batches.
BiasSquare bias_square(const BatchProducts& products);

} // namespace hipmap
