#pragma once

#include "render/film/error_cost.h"
#include "render/film/film_difference.h"

#include <string>
#include <vector>

namespace hipmap {

/// Another integrator, and what the error of the quote would cost with it.
struct QuotedIntegrator {
    std::string option; ///< "--integrator path"
    ErrorCost cost;
    BiasKnowledge bias = BiasKnowledge::unknown; ///< unknown: the cost is that of noise alone
};

/// An effect that could be left out, and what that would do.
struct QuotedEffect {
    std::string option;       ///< "--effects=-caustics"
    double saved = 0;         ///< share of the time of a pass; below zero: it costs time
    double seconds_saved = 0; ///< in as many passes as the error of the quote takes
    FilmDifference added;     ///< to the error, squared
};

/// What other settings would cost, measured by small images.
struct Quote {
    double error = 0; ///< at which times are compared
    std::vector<QuotedIntegrator> integrators;
    std::vector<QuotedEffect> effects;
    std::vector<std::string> not_compared; ///< options for which there was no time
    double seconds = 0;                    ///< that the comparison took
};

/// Describes a quote, a line for each option.
std::vector<std::string> describe(const Quote& quote);

} // namespace hipmap
