#pragma once

#include "render/film/batch_products.h"

namespace hipmap {

/// Of the normal distribution, two-sided 95 %.
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
    /// Variance in a direction, on average over the directions in which there is noise.
    double along() const { return energy > 0 ? square / energy : 0; }
};

/// docs/error.md (6).  centred: products of what each batch differs from the mean of all, times
/// sqrt(passes).  Two batches or fewer: as if all channels moved together.
Spread spread_of(const Products& centred, double channels);

/// Products of fields made into those that `spread_of` takes.
Products centred(const Products& products, const Batches& batches);

/// Pairs of passes in different batches.
double pairs_of(const Batches& batches);

/// Product of the expectations of two fields: the mean over pairs of passes from different batches,
/// whose noise is independent; docs/error.md (8).  At least two batches.
double product_of_means(const Products& products, const Batches& batches);

/// Below this lies a share of Fisher's F(above, below) like that of the normal distribution below
/// `z`; docs/error.md (7).  May be infinite.
double f_quantile(double z, double above, double below);

/// Sum of squares of the bias over the channels.
struct BiasSquare {
    double value = 0;
    double order = 0;  ///< power of the radius by which it falls, docs/error.md (12)
    double photon = 0; ///< variance that photons make in a pass, summed over the channels
    Interval interval; ///< 95 %, not cut at zero
};

/// docs/error.md (8) to (10).  Fewer than two batches: not known.
BiasSquare bias_square(const BatchProducts& products);

} // namespace hipmap
