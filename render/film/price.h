#pragma once

#include "render/film/image_error.h"

#include <span>

namespace hipmap {

/// The error when so many passes were done.
struct ErrorCheck {
    std::uint64_t passes = 0;
    double seconds = 0; ///< spent on passes until then, over all runs
    ImageError error;
    bool operator==(const ErrorCheck&) const = default;
};

/// How the square of the error falls: by_pass / N + by_photon / N^photon_power +
/// by_bias / N^bias_power, docs/error.md (12).
struct ErrorLaw {
    double by_pass = 0;
    double by_photon = 0;
    double photon_power = 2.0 / 3;
    double by_bias = 0;
    double bias_power = 2.0 / 3;
};

/// What an error costs, from the first pass on.
struct Price {
    double error = 0;
    double passes = 0; ///< whole; infinite: never
    double seconds = 0;
    double photons = 0; ///< light paths
};

/// The first number of passes above `passes` at which the error is told: 2 and then some 1.4 times
/// as many each time.
std::uint64_t next_look(std::uint64_t passes);

/// The first of them at which a render may end for its error: from 8 on, since stopping at the
/// first of many looks would stop at luck.
std::uint64_t next_check(std::uint64_t passes);

/// The law by the parts of the error at the last check.  alpha: of docs/error.md (1).  None: zero.
ErrorLaw error_law(std::span<const ErrorCheck> checks, double alpha);

/// The error after so many passes.
double error_after(const ErrorLaw& law, double passes);

/// The first number of passes at which a render may end for its error, after which that is at most
/// `error`; infinite if `error` is not above zero and the law is not zero.
double passes_for(const ErrorLaw& law, double error);

/// What a render to an `error` takes, by a law of these checks, at the pace of the last one, in
/// which passes cost the same each.
Price price_of(std::span<const ErrorCheck> checks, const ErrorLaw& law, double error,
               std::uint64_t photons_per_pass);

} // namespace hipmap
