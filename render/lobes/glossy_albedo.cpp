#include "render/lobes/glossy_albedo.h"

#include "common/math/sampling.h"
#include "render/lobes/ggx.h"

#include <array>

namespace hipmap {

namespace {

constexpr int kCosines = 32;
constexpr int kWidths = 32;

/// Points of the quadrature over facets: by their cap's cosine, and by half its azimuth.
constexpr int kCaps = 32;
constexpr int kAzimuths = 32;

/// Cosine of a column: closer to each other towards grazing, where narrow lobes change most.
float cosine_of(int column)
{
    const float x = static_cast<float>(column) / (kCosines - 1);
    return x * x;
}

/// Mean over the facets seen: each reflects its share of what masking leaves.
GlossyAlbedo integrate(float cosine, float alpha)
{
    const glm::vec3 normal(0, 0, 1);
    const glm::vec3 out(std::sqrt(std::max(0.0f, 1 - cosine * cosine)), 0, cosine);
    double f0 = 0, f90 = 0;
    for (int i = 0; i < kCaps; ++i) {
        // Denser towards the far end, where the long tails of narrow lobes are.
        const float rest = 1 - (i + 0.5f) / kCaps;
        const float weight = 3 * rest * rest;
        for (int j = 0; j < kAzimuths; ++j) {
            const glm::vec2 u(1 - rest * rest * rest, (j + 0.5f) / (2 * kAzimuths));
            const glm::vec3 half = sample_facet(normal, out, alpha, u);
            const float toward = glm::dot(out, half);
            const float cos_in = 2 * toward * half.z - cosine;
            if (!(cos_in > 0))
                continue;
            const float share = weight * ggx_shadowing(cos_in, cosine, alpha);
            const float grazing = share * std::pow(1 - std::min(toward, 1.0f), 5.0f);
            f0 += share - grazing;
            f90 += grazing;
        }
    }
    constexpr double kAll = double{kCaps} * kAzimuths;
    return {static_cast<float>(f0 / kAll), static_cast<float>(f90 / kAll)};
}

GlossyAlbedo mirror_albedo(float cosine)
{
    const float grazing = std::pow(1 - cosine, 5.0f);
    return {1 - grazing, grazing};
}

GlossyAlbedo mix(const GlossyAlbedo& a, const GlossyAlbedo& b, float t)
{
    return {a.f0 + (b.f0 - a.f0) * t, a.f90 + (b.f90 - a.f90) * t};
}

struct Table {
    std::array<std::array<GlossyAlbedo, kCosines>, kWidths> of; ///< by roughness, by cosine
    std::array<GlossyAlbedo, kWidths> average;

    Table()
    {
        for (int row = 0; row < kWidths; ++row) {
            const float roughness = static_cast<float>(row) / (kWidths - 1);
            for (int column = 0; column < kCosines; ++column)
                of[row][column] = row == 0 ? mirror_albedo(cosine_of(column))
                                           : integrate(cosine_of(column), roughness * roughness);
            average[row] = average_of(of[row]);
        }
    }

    /// 2 * integral of albedo(c) c dc, exactly for the values between columns that lookups return:
    /// linear in x = sqrt(c), so that 2 c dc = 4 x^3 dx.
    static GlossyAlbedo average_of(const std::array<GlossyAlbedo, kCosines>& row)
    {
        double f0 = 0, f90 = 0;
        for (int column = 0; column + 1 < kCosines; ++column) {
            const double x0 = double(column) / (kCosines - 1),
                         x1 = double(column + 1) / (kCosines - 1);
            const double all = std::pow(x1, 4) - std::pow(x0, 4);
            const double rising =
                (0.8 * (std::pow(x1, 5) - std::pow(x0, 5)) - x0 * all) / (x1 - x0);
            const GlossyAlbedo& a = row[column];
            const GlossyAlbedo& b = row[column + 1];
            f0 += a.f0 * (all - rising) + b.f0 * rising;
            f90 += a.f90 * (all - rising) + b.f90 * rising;
        }
        return {static_cast<float>(f0), static_cast<float>(f90)};
    }
};

const Table& table()
{
    static const Table kTable;
    return kTable;
}

/// A place between two columns or rows.
struct Between {
    int first;
    float part;

    Between(float place, int count)
    {
        const float scaled = std::clamp(place, 0.0f, 1.0f) * static_cast<float>(count - 1);
        first = std::min(static_cast<int>(scaled), count - 2);
        part = scaled - static_cast<float>(first);
    }
};

} // namespace

GlossyAlbedo glossy_albedo(float cosine, float alpha)
{
    const GlossyAlbedoRows rows = glossy_albedo_rows(alpha);
    const Between column(std::sqrt(std::max(0.0f, cosine)), kCosines);
    const auto at = [&](const GlossyAlbedo* row) {
        return mix(row[column.first], row[column.first + 1], column.part);
    };
    return mix(at(rows.low), at(rows.high), rows.part);
}

GlossyAlbedoRows glossy_albedo_rows(float alpha)
{
    const Between row(std::sqrt(alpha), kWidths);
    return {table().of[row.first].data(), table().of[row.first + 1].data(), row.part, kCosines};
}

GlossyAlbedo average_glossy_albedo(float alpha)
{
    const Between row(std::sqrt(alpha), kWidths);
    return mix(table().average[row.first], table().average[row.first + 1], row.part);
}

} // namespace hipmap
