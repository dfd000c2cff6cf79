#include "render/shading/lobe_batch.h"

#include "render/lobes/glossy_albedo.h"

#include <variant>

// foreach_target compiles what follows it once for each instruction set.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shading/lobe_batch.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

// Formulas of the lobes, operation by operation in their order, so that the bits are the same.
HWY_BEFORE_NAMESPACE();
namespace hipmap::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, 16>;
using Vec = hn::Vec<Floats>;
using Mask = hn::Mask<Floats>;

struct Colours {
    Vec r, g, b;
};

HWY_INLINE Vec all(float value)
{
    return hn::Set(Floats(), value);
}

HWY_INLINE Colours times(const Rgb& colour, Vec factor)
{
    return {hn::Mul(all(colour.r), factor), hn::Mul(all(colour.g), factor),
            hn::Mul(all(colour.b), factor)};
}

HWY_INLINE Colours times(const Colours& colours, Vec factor)
{
    return {hn::Mul(colours.r, factor), hn::Mul(colours.g, factor), hn::Mul(colours.b, factor)};
}

HWY_INLINE Colours times(const Colours& a, const Colours& b)
{
    return {hn::Mul(a.r, b.r), hn::Mul(a.g, b.g), hn::Mul(a.b, b.b)};
}

HWY_INLINE Colours plus(const Colours& a, const Colours& b)
{
    return {hn::Add(a.r, b.r), hn::Add(a.g, b.g), hn::Add(a.b, b.b)};
}

/// Some directions of a batch.
struct Directions {
    Vec x, y, z;
};

HWY_INLINE Vec dot(const Directions& a, const glm::vec3& b)
{
    return hn::Add(hn::Add(hn::Mul(a.x, all(b.x)), hn::Mul(a.y, all(b.y))), hn::Mul(a.z, all(b.z)));
}

HWY_INLINE Vec dot(const Directions& a, const Directions& b)
{
    return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}

/// Light in some directions, with its cosine to the view's normal.
struct Incoming {
    Directions in;
    Vec cosine;
};

HWY_INLINE Vec grazing_weights(Vec cosine)
{
    const Vec m = hn::Min(hn::Max(hn::Sub(all(1), cosine), all(0)), all(1));
    return hn::Mul(hn::Mul(hn::Mul(hn::Mul(m, m), m), m), m);
}

HWY_INLINE Vec dielectric_reflectances(Vec cosine, float eta)
{
    const Vec one = all(1);
    const Vec sin2 = hn::Div(hn::Sub(one, hn::Mul(cosine, cosine)), all(eta * eta));
    const Vec behind = hn::Sqrt(hn::Max(hn::Sub(one, sin2), all(0)));
    const Vec near = hn::Mul(all(eta), cosine), far = hn::Mul(all(eta), behind);
    const Vec parallel = hn::Div(hn::Sub(near, behind), hn::Add(near, behind));
    const Vec across = hn::Div(hn::Sub(cosine, far), hn::Add(cosine, far));
    const Vec mean =
        hn::Mul(all(0.5f), hn::Add(hn::Mul(parallel, parallel), hn::Mul(across, across)));
    return hn::IfThenElse(hn::Ge(sin2, one), one, mean);
}

HWY_INLINE Colours reflectances(const Reflectance& fresnel, Vec cosine)
{
    Vec weight = grazing_weights(cosine);
    if (fresnel.index > 0) {
        const float least = reflectance_of_index(fresnel.index);
        weight = hn::Div(hn::Sub(dielectric_reflectances(cosine, fresnel.index), all(least)),
                         all(1 - least));
    }
    const Rgb& f0 = fresnel.f0;
    const Colours rise = times(fresnel.f90 - f0, weight);
    return {hn::Add(all(f0.r), rise.r), hn::Add(all(f0.g), rise.g), hn::Add(all(f0.b), rise.b)};
}

/// GlossyAlbedo by lane.
struct Albedos {
    Vec f0, f90;
};

HWY_INLINE Vec mix(Vec a, Vec b, Vec part)
{
    return hn::Add(a, hn::Mul(hn::Sub(b, a), part));
}

HWY_INLINE Albedos glossy_albedos(const GlossyAlbedoRows& rows, Vec cosine)
{
    const Floats d;
    const hn::RebindToSigned<Floats> numbers;
    const Vec place = hn::Min(hn::Sqrt(hn::Max(all(0), cosine)), all(1));
    const Vec scaled = hn::Mul(place, all(static_cast<float>(rows.columns - 1)));
    // Clamped below too: lanes that are not in use may hold what is no number.
    const auto column =
        hn::Max(hn::Min(hn::ConvertTo(numbers, scaled), hn::Set(numbers, rows.columns - 2)),
                hn::Zero(numbers));
    const Vec part = hn::Sub(scaled, hn::ConvertTo(d, column));
    const auto pair = hn::Add(column, column); // of the two numbers of a column
    const auto read = [&](const GlossyAlbedo* row, std::size_t number) HWY_ATTR {
        const float* from = &row->f0 + number;
        return mix(hn::GatherIndex(d, from, pair), hn::GatherIndex(d, from + 2, pair), part);
    };
    const Vec between = all(rows.part);
    return {mix(read(rows.low, 0), read(rows.high, 0), between),
            mix(read(rows.low, 1), read(rows.high, 1), between)};
}

HWY_INLINE Colours coat_albedos(const Layers& layers, Vec cosine)
{
    if (!(layers.coat_alpha > 0))
        return reflectances(layers.coat, cosine);
    const Albedos facets = glossy_albedos(glossy_albedo_rows(layers.coat_alpha), cosine);
    return plus(times(layers.coat.f0, facets.f0), times(layers.coat.f90, facets.f90));
}

HWY_INLINE Colours values(const Lambert& lobe, const LobeView&, const Incoming&)
{
    return times(lobe.reflectance / kPi, all(1));
}

HWY_INLINE Colours values(const Burley& lobe, const LobeView& view, const Incoming& light)
{
    const Vec one = all(1);
    const Vec cos2_half = hn::Mul(all(0.5f), hn::Add(one, dot(light.in, view.out)));
    const Vec grazing = hn::Sub(hn::Mul(all(2 * lobe.shape.roughness), cos2_half), all(0.5f));
    const Vec shape = hn::Mul(hn::Add(one, hn::Mul(grazing, grazing_weights(light.cosine))),
                              hn::Add(one, hn::Mul(grazing, all(grazing_weight(view.cosine)))));
    return times(lobe.reflectance, hn::Div(shape, all(kPi)));
}

HWY_INLINE Colours values(const OrenNayar& lobe, const LobeView& view, const Incoming& light)
{
    const float roughness = lobe.shape.roughness;
    const Vec one = all(1), seen = all(view.cosine);
    const Vec s = hn::Sub(dot(light.in, view.out), hn::Mul(light.cosine, seen));
    const Vec t = hn::IfThenElse(hn::Gt(s, all(0)), hn::Max(light.cosine, seen), one);
    const Vec rough = hn::Add(one, hn::Div(hn::Mul(all(roughness), s), t));
    const Vec shape = hn::Div(rough, all(1 + (0.5f - 2 / (3 * kPi)) * roughness));
    return times(lobe.reflectance, hn::Div(shape, all(kPi)));
}

HWY_INLINE Vec slopes(Vec cosine, float alpha)
{
    const float alpha2 = alpha * alpha;
    return hn::Sqrt(hn::Add(all(alpha2), hn::Mul(hn::Mul(all(1 - alpha2), cosine), cosine)));
}

HWY_INLINE Vec distributions(const glm::vec3& normal, const Directions& half, float alpha)
{
    const Vec nx = all(normal.x), ny = all(normal.y), nz = all(normal.z);
    const Directions across{hn::Sub(hn::Mul(ny, half.z), hn::Mul(half.y, nz)),
                            hn::Sub(hn::Mul(nz, half.x), hn::Mul(half.z, nx)),
                            hn::Sub(hn::Mul(nx, half.y), hn::Mul(half.x, ny))};
    const Vec cosine = dot(half, normal), alpha2 = all(alpha * alpha);
    const Vec spread = hn::Add(dot(across, across), hn::Mul(hn::Mul(alpha2, cosine), cosine));
    const Vec density = hn::Div(alpha2, hn::Mul(hn::Mul(all(kPi), spread), spread));
    return hn::IfThenElseZero(hn::Gt(cosine, all(0)), density);
}

HWY_INLINE Colours values(const MicrofacetReflection& lobe, const LobeView& view,
                          const Incoming& light)
{
    const float alpha = lobe.facets.alpha;
    const Directions& in = light.in;
    const Directions sum{hn::Add(in.x, all(view.out.x)), hn::Add(in.y, all(view.out.y)),
                         hn::Add(in.z, all(view.out.z))};
    const Vec length = hn::Sqrt(dot(sum, sum));
    const Directions half{hn::Div(sum.x, length), hn::Div(sum.y, length), hn::Div(sum.z, length)};
    const Vec visibility =
        hn::Div(all(0.5f), hn::Add(hn::Mul(all(view.cosine), slopes(light.cosine, alpha)),
                                   hn::Mul(light.cosine, slopes(all(view.cosine), alpha))));
    const Colours fresnel = reflectances(lobe.fresnel, hn::Mul(length, all(0.5f)));
    const Colours single =
        times(fresnel, hn::Mul(distributions(view.normal, half, alpha), visibility));
    if (is_black(lobe.multiple))
        return single;
    const GlossyAlbedoRows rows = glossy_albedo_rows(alpha);
    const auto lost = [&](Vec cosine) HWY_ATTR {
        const Albedos white = glossy_albedos(rows, cosine);
        return hn::Sub(all(1), hn::Add(white.f0, white.f90));
    };
    return plus(single, times(lobe.multiple, hn::Mul(lost(light.cosine), lost(all(view.cosine)))));
}

/// Returns what one lobe sends of light to the view, below the layers.
template <typename Kind>
HWY_INLINE Colours weights(const Kind& lobe, Depth depth, const SeenLobes& at,
                           const Incoming& light)
{
    const Colours value = values(lobe, at.view, light);
    if (at.bsdf.is_diffuse)
        return value;
    Colours in = times(value, hn::Abs(light.cosine));
    const Layers& layers = at.bsdf.layers;
    if (layers.any && depth == Depth::diffuse && layers.coated) {
        const Colours lost = coat_albedos(layers, light.cosine);
        const Vec one = all(1);
        in = times(in, Colours{hn::Sub(one, lost.r), hn::Sub(one, lost.g), hn::Sub(one, lost.b)});
    }
    const Rgb& seen = at.seen[static_cast<std::size_t>(depth)];
    return times(in, Colours{hn::Div(all(seen.r), light.cosine), hn::Div(all(seen.g), light.cosine),
                             hn::Div(all(seen.b), light.cosine)});
}

HWY_INLINE void add(Vec part, float* to)
{
    const Floats d;
    hn::Store(hn::Add(hn::Load(d, to), part), d, to);
}

HWY_INLINE Incoming light_at(const SeenLobes& at, const DirectionBatch& in, std::size_t lane)
{
    const Floats d;
    const Directions from{hn::Load(d, &in.x[lane]), hn::Load(d, &in.y[lane]),
                          hn::Load(d, &in.z[lane])};
    return {from, dot(from, at.view.normal)};
}

template <typename Kind>
HWY_INLINE void add_lobe(const PlacedLobe& lobe, const SeenLobes& at, const DirectionBatch& in,
                         std::size_t count, RgbBatch& out)
{
    const Kind* of = std::get_if<Kind>(&lobe.lobe);
    for (std::size_t lane = 0; of != nullptr && lane < count; lane += hn::Lanes(Floats())) {
        const Colours sent = weights(*of, lobe.depth, at, light_at(at, in, lane));
        add(sent.r, &out.r[lane]);
        add(sent.g, &out.g[lane]);
        add(sent.b, &out.b[lane]);
    }
}

/// Returns the lanes of light that comes from below, or that some lobe folds to there.
HWY_INLINE Mask left_out(const SeenLobes& at, const Incoming& light, bool folds)
{
    const Vec zero = all(0);
    const Mask above = hn::Gt(light.cosine, zero);
    if (!folds)
        return hn::Not(above);
    const Directions& in = light.in;
    const Vec up = dot(in, at.normal), twice = hn::Mul(all(2), up);
    const Directions mirrored{hn::Sub(in.x, hn::Mul(twice, all(at.normal.x))),
                              hn::Sub(in.y, hn::Mul(twice, all(at.normal.y))),
                              hn::Sub(in.z, hn::Mul(twice, all(at.normal.z)))};
    const Mask folded = hn::And(hn::Gt(up, zero), hn::Gt(dot(mirrored, at.view.normal), zero));
    return hn::Or(hn::Not(above), folded);
}

std::uint64_t WeighBatch(const SeenLobes& at, const DirectionBatch& in, std::size_t count,
                         RgbBatch& out)
{
    const Floats d;
    bool folds = false;
    out = {};
    for (const PlacedLobe& lobe : at.bsdf.lobes()) {
        if (lobe.handled != at.handled || lobe.transmits)
            continue;
        folds = folds || (lobe.folds && at.view.normal != at.normal);
        add_lobe<Lambert>(lobe, at, in, count, out);
        add_lobe<Burley>(lobe, at, in, count, out);
        add_lobe<OrenNayar>(lobe, at, in, count, out);
        add_lobe<MicrofacetReflection>(lobe, at, in, count, out);
    }
    std::uint64_t left = 0;
    for (std::size_t lane = 0; lane < count; lane += hn::Lanes(d)) {
        std::uint8_t bits[8] = {};
        hn::StoreMaskBits(d, left_out(at, light_at(at, in, lane), folds), bits);
        left |= (std::uint64_t{bits[0]} | std::uint64_t{bits[1]} << 8) << lane;
    }
    return count < kBatch ? left & ((std::uint64_t{1} << count) - 1) : left;
}

} // namespace hipmap::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hipmap {

HWY_EXPORT(WeighBatch);

namespace {

bool is_known(const PlacedLobe& lobe, const LobeView& view)
{
    if (const auto* facets = std::get_if<MicrofacetReflection>(&lobe.lobe))
        return lobe.depth != Depth::clearcoat && !facets->facets.is_anisotropic(view);
    return std::holds_alternative<Lambert>(lobe.lobe) ||
           std::holds_alternative<Burley>(lobe.lobe) ||
           std::holds_alternative<OrenNayar>(lobe.lobe);
}

} // namespace

bool can_weigh_batch(const SeenLobes& lobes)
{
    const Layers& layers = lobes.bsdf.layers;
    return !(layers.any && (layers.sheen > 0 || layers.clearcoat > 0)) &&
           std::ranges::all_of(lobes.bsdf.lobes(), [&](const PlacedLobe& lobe) {
               return lobe.handled != lobes.handled || lobe.transmits || is_known(lobe, lobes.view);
           });
}

std::uint64_t weigh_batch(const SeenLobes& lobes, const DirectionBatch& in, std::size_t count,
                          RgbBatch& out)
{
    return HWY_DYNAMIC_DISPATCH(WeighBatch)(lobes, in, count, out);
}

} // namespace hipmap
#endif
