#include "render/shading/dispersion.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hipmap {

namespace {

constexpr std::size_t kBins = 340; ///< a nanometre each
constexpr float kShortest = 380;   ///< nanometres

/// A bell with another width on either side of its top.
double bell(double nanometres, double top, double below, double above)
{
    const double off = (nanometres - top) / (nanometres < top ? below : above);
    return std::exp(-0.5 * off * off);
}

/// The CIE's observer of 1931 by a fit (Wyman, Sloan and Shirley 2013), in linear RGB.  What a
/// channel would have to lack is cut off: there is no negative light.
glm::dvec3 response(double w)
{
    const double x = 1.056 * bell(w, 599.8, 37.9, 31.0) + 0.362 * bell(w, 442.0, 16.0, 26.7) -
                     0.065 * bell(w, 501.1, 20.4, 26.2);
    const double y = 0.821 * bell(w, 568.8, 46.9, 40.5) + 0.286 * bell(w, 530.9, 16.3, 31.1);
    const double z = 1.217 * bell(w, 437.0, 11.8, 36.0) + 0.681 * bell(w, 459.0, 26.0, 13.8);
    const glm::dvec3 rgb(3.2406 * x - 1.5372 * y - 0.4986 * z,
                         -0.9689 * x + 1.8758 * y + 0.0415 * z,
                         0.0557 * x - 0.2040 * y + 1.0570 * z);
    return glm::max(rgb, glm::dvec3(0));
}

/// The spectrum by bins: running probability at their ends, and the weight of light drawn from
/// them.
struct Spectrum {
    std::array<float, kBins> cumulative;
    std::array<Rgb, kBins> weight;
};

Spectrum make_spectrum()
{
    std::array<glm::dvec3, kBins> responses;
    glm::dvec3 sum(0.0);
    for (std::size_t i = 0; i < kBins; ++i)
        sum += responses[i] = response(kShortest + static_cast<double>(i) + 0.5);
    Spectrum out;
    double running = 0;
    for (std::size_t i = 0; i < kBins; ++i) {
        const glm::dvec3 share = responses[i] / sum;
        const double probability = (share.x + share.y + share.z) / 3;
        running += probability;
        out.cumulative[i] = static_cast<float>(running);
        out.weight[i] = probability > 0 ? Rgb(share / probability) : Rgb(1);
    }
    return out;
}

} // namespace

WavelengthSample sample_wavelength(float u)
{
    static const Spectrum spectrum = make_spectrum();
    const auto last = spectrum.cumulative.end() - 1;
    const auto found = std::upper_bound(spectrum.cumulative.begin(), last, u);
    const auto bin = static_cast<std::size_t>(found - spectrum.cumulative.begin());
    const float before = bin == 0 ? 0 : spectrum.cumulative[bin - 1];
    const float width = spectrum.cumulative[bin] - before;
    const float inside = width > 0 ? std::min((u - before) / width, 1.0f) : 0.5f;
    return {kShortest + static_cast<float>(bin) + inside, spectrum.weight[bin]};
}

float dispersed_index(float ior, float dispersion, float nanometres)
{
    const float per_abbe = dispersion / 20;
    const float bend = 523655 / (nanometres * nanometres) - 1.5168f;
    return std::max(1.0f, ior + (ior - 1) * per_abbe * bend);
}

void choose_wavelength(float& nanometres, Rgb& carried, RandomSequence& random)
{
    if (nanometres != 0)
        return;
    const WavelengthSample drawn = sample_wavelength(random.next());
    nanometres = drawn.nanometres;
    carried *= drawn.weight;
}

void disperse_here(Interaction& at, float& nanometres, Rgb& carried, RandomSequence& random)
{
    choose_wavelength(nanometres, carried, random);
    const Bsdf& bsdf = at.bsdf();
    at.ior = dispersed_index(bsdf.ior, bsdf.dispersion, nanometres);
    if (bsdf.rough_glass)
        at.ior = std::max(at.ior, kLeastRoughIndex);
}

} // namespace hipmap
