#include "render/film/price.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hipmap {

namespace {

double square_of(double x)
{
    return x * x;
}

/// The square of the error that a law gives.
double square_after(const ErrorLaw& law, double passes)
{
    return law.by_pass / passes + law.by_photon / std::pow(passes, law.photon_power);
}

/// Least squares of what checks differ from the law, relative to them; the later count more, by
/// their passes.  Neither part below zero.
ErrorLaw fit_shape(std::span<const ErrorCheck> checks, double power)
{
    double aa = 0, ab = 0, bb = 0, a1 = 0, b1 = 0;
    int used = 0;
    for (const ErrorCheck& check : checks) {
        const auto passes = static_cast<double>(check.passes);
        const double square = square_of(check.error.error);
        if (check.passes < kBatches || !(square > 0))
            continue;
        ++used;
        const double a = 1 / (passes * square), b = 1 / (std::pow(passes, power) * square);
        aa += passes * a * a;
        ab += passes * a * b;
        bb += passes * b * b;
        a1 += passes * a;
        b1 += passes * b;
    }
    const double determinant = aa * bb - ab * ab;
    // Checks at one number of passes do not tell the parts apart.
    const ErrorLaw both{(a1 * bb - b1 * ab) / determinant, (b1 * aa - a1 * ab) / determinant,
                        power};
    if (used < 2 || !(both.by_pass > 0) || !std::isfinite(both.by_pass))
        return {0, 1, power};
    return both.by_photon > 0 ? both : ErrorLaw{1, 0, power};
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
    return next_look(std::max(passes, kBatches - 1));
}

ErrorLaw fit_law(std::span<const ErrorCheck> checks, double alpha)
{
    if (checks.empty())
        return {};
    const ErrorCheck& last = checks.back();
    const double power = std::min(alpha, 2 - 2 * alpha);
    const ErrorLaw shape = last.error.bias == BiasKnowledge::from_radii ? fit_shape(checks, power)
                                                                        : ErrorLaw{1, 0, power};
    const double scale =
        square_of(last.error.error) / square_after(shape, static_cast<double>(last.passes));
    return {scale * shape.by_pass, scale * shape.by_photon, power};
}

double error_after(const ErrorLaw& law, double passes)
{
    return std::sqrt(square_after(law, passes));
}

double passes_for(const ErrorLaw& law, double error)
{
    if (square_after(law, 1) <= square_of(error))
        return 1;
    if (!(error > 0))
        return std::numeric_limits<double>::infinity();
    double low = 1, high = 2;
    while (square_after(law, high) > square_of(error) && std::isfinite(high))
        low = high, high *= 2;
    for (int i = 0; i < 60 && high - low > 0.5; ++i) {
        const double middle = (low + high) / 2;
        (square_after(law, middle) > square_of(error) ? low : high) = middle;
    }
    return std::ceil(high);
}

Price price_of(std::span<const ErrorCheck> checks, const ErrorLaw& law, double error,
               std::uint64_t photons_per_pass)
{
    Price price;
    price.error = error;
    if (checks.empty())
        return price;
    const ErrorCheck& last = checks.back();
    price.passes = passes_for(law, error);
    price.seconds = price.passes * last.seconds / static_cast<double>(last.passes);
    price.photons = price.passes * static_cast<double>(photons_per_pass);
    return price;
}

} // namespace hipmap
