#include "render/lobes/layers.h"

#include "render/lobes/glossy_albedo.h"
#include "render/lobes/sheen_albedo.h"

#include <array>

namespace hipmap {

namespace {

/// Cosine-weighted average by three-point Gauss-Legendre on eight parts: layers change fast only
/// near grazing.
Rgb average_over_hemisphere(const Layers& layers)
{
    struct Node {
        float place, weight;
    };
    constexpr int kParts = 8;
    constexpr std::array<Node, 3> kNodes{
        {{-0.7745966692f, 5.0f / 18}, {0.0f, 8.0f / 18}, {0.7745966692f, 5.0f / 18}}};
    Rgb sum(0.0f);
    for (int part = 0; part < kParts; ++part)
        for (const Node& node : kNodes) {
            const float x = (static_cast<float>(part) + 0.5f * (1 + node.place)) / kParts;
            const float cosine = x * x; // 2 c dc = 4 x^3 dx
            sum += transmitted_by(layers, Depth::diffuse, cosine) *
                   (node.weight / kParts * 4 * x * x * x);
        }
    return sum;
}

} // namespace

Rgb reflection_albedo(const Reflectance& fresnel, float cosine, float alpha)
{
    return alpha > 0 ? glossy_albedo(cosine, alpha).of(fresnel.f0, fresnel.f90) : fresnel(cosine);
}

Rgb average_reflection_albedo(const Reflectance& fresnel, float alpha)
{
    if (!(alpha > 0))
        return fresnel.average();
    GlossyAlbedo facets = average_glossy_albedo(alpha); // of Schlick's curve
    const float grazing = facets.f90 * fresnel.average_weight() / kAverageGrazingWeight;
    facets.f0 -= grazing - facets.f90;
    facets.f90 = grazing;
    return facets.of(fresnel.f0, fresnel.f90);
}

Rgb transmitted_by(const Layers& layers, Depth depth, const Incidence& along)
{
    Rgb out(1);
    if (!layers.any || depth == Depth::clearcoat)
        return out;
    if (depth == Depth::diffuse && layers.coated)
        out -= reflection_albedo(layers.coat, along.cosine, layers.coat_alpha);
    if (depth >= Depth::reflection && layers.sheen > 0)
        out *= 1 - layers.sheen * sheen_albedo(along.cosine, layers.sheen_alpha);
    if (layers.clearcoat > 0)
        out *= 1 - reflection_albedo(clearcoat_fresnel(layers.clearcoat), along.coat,
                                     layers.clearcoat_alpha)
                       .x;
    return out;
}

void finish(Layers& layers)
{
    layers.any = !layers.adds && (layers.coated || layers.sheen > 0 || layers.clearcoat > 0);
    if (!layers.any)
        return;
    if (layers.sheen > 0 || layers.clearcoat > 0)
        layers.diffuse_average = average_over_hemisphere(layers);
    else if (layers.coated)
        layers.diffuse_average = 1.0f - average_reflection_albedo(layers.coat, layers.coat_alpha);
}

} // namespace hipmap
