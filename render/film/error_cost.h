#pragma once

#include "render/film/expected_light.h"
#include "render/film/image_error.h"

#include <span>

namespace hipmap {

/// The error after a number of passes.
struct ErrorCheck {
    std::uint64_t passes = 0;
    double seconds = 0; ///< spent on passes until then, over all runs
    ImageError error;
    bool operator==(const ErrorCheck&) const = default;
};

/// The model of the error: its square is by_pass / N + by_photon / N^photon_power + by_bias /
/// N^bias_power + by_clamp, docs/error.md (12).
struct ErrorLaw {
    double by_pass = 0;
    double by_photon = 0;
    double photon_power = 2.0 / 3;
    double by_bias = 0;
    double bias_power = 2.0 / 3;
    double by_clamp = 0;     ///< which no pass makes smaller
    ExpectedLight rare = {}; ///< of pilots, which adds noise once it is found, (29)
    double passes = 0;       ///< that the law was fitted to
};

/// What a render costs beside the time of its passes.
struct CostBeside {
    std::uint64_t photons = 0; ///< light paths of a pass
    double before = 0;         ///< s before the first pass, such as those of pilots
};

/// What an error costs, counted from the start of the render.  The most is for passes that find
/// rare light, docs/error.md (29).
struct ErrorCost {
    double error = 0;
    double passes = 0;  ///< whole; infinite: never
    double seconds = 0; ///< with those before the first pass
    double photons = 0; ///< light paths
    double most_passes = 0;
    double most_seconds = 0;

    bool is_range() const { return most_passes > passes; }
};

/// Returns the first number of passes above `passes` at which the error is estimated: 2, then some
/// 1.4 times as many each time.
std::uint64_t next_look(std::uint64_t passes);

/// Returns the first number of passes above `passes` at which a render may end because of its
/// error: from kFewestBatches on, since the first of many estimates to be low may be low by luck.
std::uint64_t next_check(std::uint64_t passes);

/// Fits the law to the parts of the error at the last check.  alpha: of docs/error.md (1).  rare:
/// what pilots expect.  No checks: zero.
ErrorLaw error_law(std::span<const ErrorCheck> checks, double alpha,
                   const ExpectedLight& rare = {});

/// Returns the error after a number of passes.
double error_after(const ErrorLaw& law, double passes);

/// Returns the first number of passes at which a render may end with at most `error`; infinite if
/// `error` is not above zero and the law is not zero.
double passes_for(const ErrorLaw& law, double error);

/// Predicts the passes and the time of a render to `error`, by a law fitted to these checks, with
/// passes that cost as much as at the last check.
ErrorCost error_cost(std::span<const ErrorCheck> checks, const ErrorLaw& law, double error,
                     const CostBeside& beside);

} // namespace hipmap
