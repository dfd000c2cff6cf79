#include "render/lobes/sheen_albedo.h"

#include "common/math/sampling.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hipmap {

namespace {

/// Below it the fit of the shadowing leaves what it was fitted to.
constexpr float kLeastCosine = 1e-4f;

constexpr int kCosines = 40;
constexpr int kWidths = 24;

/// Points of the quadrature: by cosine, and by half the azimuth.
constexpr int kPolar = 96;
constexpr int kAzimuths = 48;

/// Smith's Lambda, as Estevez and Kulla fitted it.
float shadowing(float cosine, float alpha)
{
    const float t = (1 - alpha) * (1 - alpha);
    const auto mix = [t](float wide, float narrow) { return wide + (narrow - wide) * t; };
    const float a = mix(21.5473f, 25.3245f), b = mix(3.82987f, 3.32435f);
    const float c = mix(0.19823f, 0.16801f), d = mix(-1.97760f, -1.27393f);
    const float e = mix(-4.32054f, -4.85967f);
    const auto fit = [&](float x) { return a / (1 + b * std::pow(x, c)) + d * x + e; };
    return std::exp(cosine < 0.5f ? fit(cosine) : 2 * fit(0.5f) - fit(1 - cosine));
}

/// Cosine of a column: closer to each other towards grazing.
float cosine_of(int column)
{
    const float x = static_cast<float>(column) / (kCosines - 1);
    return std::max(kLeastCosine, x * x * x);
}

float alpha_of(int row)
{
    const float y = static_cast<float>(row) / (kWidths - 1);
    return kLeastSheenAlpha + (1 - kLeastSheenAlpha) * y * y;
}

/// Over the cosine's square root, where the lobe is smooth towards grazing, and the azimuth.
float integrate(float cosine, float alpha)
{
    const float sine = std::sqrt(1 - cosine * cosine);
    double sum = 0;
    for (int i = 0; i < kPolar; ++i) {
        const float x = (static_cast<float>(i) + 0.5f) / kPolar;
        const float cos_in = x * x, sin_in = std::sqrt(1 - cos_in * cos_in);
        const float across = cosine + cos_in;
        const float weight = 2 * x * cos_in; // 2 x dx = dc
        for (int j = 0; j < kAzimuths; ++j) {
            const float turn = (static_cast<float>(j) + 0.5f) / kAzimuths * kPi;
            const float along2 = sine * sine + sin_in * sin_in + 2 * sine * sin_in * std::cos(turn);
            const float sin2_half = along2 / (along2 + across * across);
            sum += double{weight} * sheen_lobe(cos_in, cosine, sin2_half, alpha);
        }
    }
    return static_cast<float>(2 * kPi * sum / (double{kPolar} * kAzimuths));
}

using Table = std::array<std::array<float, kCosines>, kWidths>; ///< by alpha, by cosine

Table make_table()
{
    Table out;
    for (int row = 0; row < kWidths; ++row)
        for (int column = 0; column < kCosines; ++column)
            out[row][column] = integrate(cosine_of(column), alpha_of(row));
    return out;
}

} // namespace

float sheen_lobe(float cos_in, float cos_out, float sin2_half, float alpha)
{
    const float in = std::max(kLeastCosine, cos_in), out = std::max(kLeastCosine, cos_out);
    const float spread =
        (2 + 1 / alpha) * std::pow(std::clamp(sin2_half, 0.0f, 1.0f), 0.5f / alpha) / (2 * kPi);
    return spread / ((1 + shadowing(in, alpha) + shadowing(out, alpha)) * 4 * in * out);
}

float sheen_albedo(float cosine, float alpha)
{
    static const Table kTable = make_table();
    const auto between = [](float place, int count, int& first) {
        const float scaled = std::clamp(place, 0.0f, 1.0f) * static_cast<float>(count - 1);
        first = std::min(static_cast<int>(scaled), count - 2);
        return scaled - static_cast<float>(first);
    };
    int column = 0, row = 0;
    const float x = between(std::cbrt(std::max(0.0f, cosine)), kCosines, column);
    const float y =
        between(std::sqrt(std::max(0.0f, (alpha - kLeastSheenAlpha) / (1 - kLeastSheenAlpha))),
                kWidths, row);
    const auto at = [&](int r) {
        return kTable[r][column] + (kTable[r][column + 1] - kTable[r][column]) * x;
    };
    return at(row) + (at(row + 1) - at(row)) * y;
}

} // namespace hipmap
