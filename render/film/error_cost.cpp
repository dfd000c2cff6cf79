#include "render/film/error_cost.h"

#include "common/math/square.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hipmap {

namespace {

/// Passes that nobody waits for.
constexpr std::uint64_t kForever = std::uint64_t{1} << 50;

/// The order of the bias in the radius, of smooth irradiance, and the passes after which half of
/// what is measured counts as bias, the rest as noise.
constexpr double kBiasOrder = 2, kPassesOfBias = 16;

/// The square of the error that a law gives.
double square_after(const ErrorLaw& law, double passes)
{
    return law.by_pass / passes + law.by_photon / std::pow(passes, law.photon_power) +
           law.by_bias / std::pow(passes, law.bias_power) + law.by_clamp;
}

/// Returns the square of the error by a law, if the passes find rare light, docs/error.md (29).
double most_square_after(const ErrorLaw& law, double passes)
{
    return square_after(law, passes) + unmet_square(law.rare, law.passes, passes);
}

/// Returns the first number of passes at which a render may end by its error.  square(law, passes):
/// of the error.
template <typename Square>
double first_check(const ErrorLaw& law, double error, const Square& square)
{
    constexpr double kRounding = 1e-9; // relative: of a law that is met exactly
    const double wanted = square_of(error) * (1 + kRounding);
    std::uint64_t passes = next_check(0);
    while (square(law, static_cast<double>(passes)) > wanted) {
        if (passes > kForever)
            return std::numeric_limits<double>::infinity();
        passes = next_check(passes);
    }
    return static_cast<double>(passes);
}

} // namespace

std::uint64_t next_look(std::uint64_t passes)
{
    constexpr double kSpacing = 1.4142135623730951;
    double look = 2;
    while (std::round(look) <= static_cast<double>(passes))
        look *= kSpacing;
    return static_cast<std::uint64_t>(std::round(look));
}

std::uint64_t next_check(std::uint64_t passes)
{
    return next_look(std::max(passes, kFewestBatches - 1));
}

ErrorLaw error_law(std::span<const ErrorCheck> checks, double alpha, const ExpectedLight& rare)
{
    if (checks.empty())
        return {};
    const ImageError& error = checks.back().error;
    const auto passes = static_cast<double>(checks.back().passes);
    ErrorLaw law;
    law.photon_power = alpha;
    law.bias_power = (1 - alpha) * kBiasOrder;
    law.by_photon = error.photon2 * std::pow(passes, law.photon_power);
    const double bias2 = std::max(error.bias2, 0.0);
    const double share = passes / (passes + kPassesOfBias);
    law.by_pass = (error.noise2 + error.removed2 - error.photon2 + (1 - share) * bias2) * passes;
    law.by_bias = share * bias2 * std::pow(passes, law.bias_power);
    law.by_clamp = error.clamp2;
    law.rare = rare;
    law.passes = passes;
    return law;
}

double error_after(const ErrorLaw& law, double passes)
{
    return std::sqrt(square_after(law, passes));
}

double passes_for(const ErrorLaw& law, double error)
{
    return first_check(law, error, square_after);
}

ErrorCost error_cost(std::span<const ErrorCheck> checks, const ErrorLaw& law, double error,
                     const CostBeside& beside)
{
    ErrorCost cost;
    cost.error = error;
    if (checks.empty())
        return cost;
    const ErrorCheck& last = checks.back();
    const double of_pass = last.seconds / static_cast<double>(last.passes);
    cost.passes = passes_for(law, error);
    cost.seconds = beside.before + cost.passes * of_pass;
    const bool met = last.passes >= kFewestBatches && last.error.error <= error;
    cost.most_passes = met ? cost.passes : first_check(law, error, most_square_after);
    cost.most_seconds = beside.before + cost.most_passes * of_pass;
    cost.photons = cost.passes * static_cast<double>(beside.photons);
    return cost;
}

} // namespace hipmap
