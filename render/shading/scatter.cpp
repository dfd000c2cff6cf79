#include "render/shading/scatter.h"

#include "render/media/phase.h"
#include "render/shading/lobe_value.h"

#include <array>

namespace hipmap {

namespace {

/// Calls take(view, from) for `in` and, where light is folded, for its mirror image, as far as the
/// lobe takes light from there.
template <typename Take>
void over_folded(const Interaction& at, const PlacedLobe& lobe, const glm::vec3& in,
                 const Take& take)
{
    const float side = glm::dot(in, at.normal) < 0 ? -1.0f : 1.0f;
    if (side < 0 && !lobe.transmits)
        return;
    const LobeView view = view_of(at, lobe.depth);
    if (side * glm::dot(in, view.normal) > 0)
        take(view, in);
    if (!lobe.folds || view.normal == at.normal)
        return;
    const glm::vec3 image = mirrored(in, at.normal);
    if (side * glm::dot(image, view.normal) > 0)
        take(view, image);
}

/// Probability per steradian that a direction is drawn from a lobe.
float pdf_of(const Interaction& at, const PlacedLobe& lobe, const glm::vec3& in)
{
    float out = 0;
    over_folded(at, lobe, in, [&](const LobeView& view, const glm::vec3& from) {
        out += pdf(lobe.lobe, view, from);
    });
    return out;
}

Scattered scattered_by(const Interaction& at, const PlacedLobe& lobe, const glm::vec3& in)
{
    Scattered out;
    over_folded(at, lobe, in, [&](const LobeView& view, const glm::vec3& from) {
        out.value += value_of(at, lobe, view, from);
        out.pdf += pdf(lobe.lobe, view, from);
    });
    const Layers& layers = at.bsdf().layers;
    if (layers.any)
        out.value *= transmitted_by(layers, lobe.depth, at.seen());
    return out;
}

/// Calls a function with the diffuse lobe of a surface that has no other lobe and no layers, if it
/// is of a common kind: such a surface needs less than the formulas of all lobes.  False: it has
/// others.
template <typename Function>
bool with_diffuse_alone(const Interaction& at, const PlacedLobe& lobe, const Function& function)
{
    if (!at.is_diffuse())
        return false;
    if (const Burley* burley = std::get_if<Burley>(&lobe.lobe))
        function(*burley);
    else if (const Lambert* lambert = std::get_if<Lambert>(&lobe.lobe))
        function(*lambert);
    else
        return false;
    return true;
}

/// `scattered_by` for a diffuse lobe alone.
template <typename Diffuse>
Scattered scattered_by_diffuse(const Interaction& at, const Diffuse& lobe, const glm::vec3& in)
{
    const float cosine = glm::dot(in, at.shading_normal);
    if (glm::dot(in, at.normal) < 0 || !(cosine > 0))
        return {};
    const LobeView view = view_of(at, Depth::diffuse);
    return {lobe.eval(view, in) * cosine, lobe.pdf(view, in)};
}

/// `sample_below` for a diffuse lobe alone.
template <typename Diffuse>
LobeSample sample_diffuse(const Interaction& at, const Diffuse& lobe, RandomSequence& random)
{
    LobeSample out = lobe.sample(view_of(at, Depth::diffuse), random);
    if (!(glm::dot(out.direction, at.normal) > 0))
        out.weight = Rgb(0);
    return out;
}

template <typename Diffuse>
ScatterSample sample_scatter_by_diffuse(const Interaction& at, const Diffuse& lobe,
                                        RandomSequence& random)
{
    ScatterSample out{sample_diffuse(at, lobe, random)};
    if (!is_black(out.weight) && glm::dot(out.direction, at.shading_normal) > 0)
        out.pdf = lobe.pdf(view_of(at, Depth::diffuse), out.direction);
    return out;
}

/// By which each lobe of a set is drawn; zero for the others.
struct LobeProbabilities {
    std::array<float, Bsdf::kMostLobes> of{};
    float sum = 0.0f;

    LobeProbabilities(const Interaction& at, Lobes lobes)
    {
        const Bsdf& bsdf = at.bsdf();
        for (std::size_t i = 0; i < bsdf.count; ++i)
            if (bsdf.all[i].handled == lobes)
                sum += of[i] = max_channel(albedo_of(at, bsdf.all[i]));
    }
    float operator[](std::size_t lobe) const { return of[lobe] / sum; }
    /// u: [0, 1).
    std::size_t pick(float u) const
    {
        std::size_t lobe = 0, last = 0;
        for (u *= sum; lobe < of.size(); ++lobe) {
            if (!(of[lobe] > 0))
                continue;
            last = lobe;
            if (u < of[lobe])
                return lobe;
            u -= of[lobe];
        }
        return last;
    }
};

Scattered scattered_by_set(const Interaction& at, const glm::vec3& in,
                           const LobeProbabilities& probabilities)
{
    Scattered out;
    for (std::size_t i = 0; i < at.bsdf().count; ++i) {
        if (!(probabilities.of[i] > 0))
            continue;
        const Scattered one = scattered_by(at, at.bsdf().all[i], in);
        out.value += one.value;
        out.pdf += probabilities[i] * one.pdf;
    }
    return out;
}

/// By the phase function of a medium.
Scattered scattered_in_medium(const Interaction& at, const glm::vec3& in, Lobes lobes)
{
    if (lobes != Lobes::gathered)
        return {};
    const float value = phase_value(*at.phase, -glm::dot(at.back, in));
    return {Rgb(value), value};
}

ScatterSample sample_in_medium(const Interaction& at, Lobes lobes, RandomSequence& random)
{
    ScatterSample out;
    out.direction = sample_phase(*at.phase, -at.back, random.next2());
    out.pdf = scattered_in_medium(at, out.direction, lobes).pdf;
    out.weight = Rgb(out.pdf > 0 ? 1.0f : 0.0f);
    return out;
}

/// Draws a direction from a lobe below its layers.
LobeSample sample_below(const Interaction& at, const PlacedLobe& lobe, RandomSequence& random)
{
    LobeSample out = sample(lobe.lobe, view_of(at, lobe.depth), random);
    if (is_black(out.weight))
        return out;
    const Layers& layers = at.bsdf().layers;
    if (layers.any)
        out.weight *= transmitted_by(layers, lobe.depth, incidence_on_side(at, out.direction)) *
                      transmitted_by(layers, lobe.depth, at.seen());
    const float side = out.transmitted ? -1.0f : 1.0f;
    if (side * glm::dot(out.direction, at.normal) > 0)
        return out;
    if (lobe.folds) // bent past the face by the shading normal
        out.direction = mirrored(out.direction, at.normal);
    else
        out.weight = Rgb(0);
    return out;
}

/// What a particle that the clear coat scatters carries of (9) by the coat's own normal, over that
/// by the surface's.
float coat_correction(const Interaction& at, const glm::vec3& towards)
{
    const auto ratio = [&](const glm::vec3& normal) {
        const float out = std::abs(glm::dot(towards, normal));
        return out > 0 ? std::abs(glm::dot(at.back, normal)) / out : 0.0f;
    };
    const float by_surface = ratio(at.shading_normal);
    return by_surface > 0 ? ratio(at.coat_normal) / by_surface : 0.0f;
}

} // namespace

Scattered scattered(const Interaction& at, const glm::vec3& in, Lobes lobes)
{
    if (at.phase != nullptr)
        return scattered_in_medium(at, in, lobes);
    if (const PlacedLobe* lobe = at.bsdf().single(lobes)) {
        Scattered out;
        if (!with_diffuse_alone(at, *lobe, [&](const auto& diffuse) {
                out = scattered_by_diffuse(at, diffuse, in);
            }))
            out = scattered_by(at, *lobe, in);
        return out;
    }
    return scattered_by_set(at, in, {at, lobes});
}

LobeSample sample_lobe(const Interaction& at, const PlacedLobe& lobe, RandomSequence& random)
{
    LobeSample out;
    if (with_diffuse_alone(at, lobe,
                           [&](const auto& diffuse) { out = sample_diffuse(at, diffuse, random); }))
        return out;
    out = sample_below(at, lobe, random);
    if (lobe.depth == Depth::clearcoat && at.has_coat_normal())
        out.weight *= coat_correction(at, out.direction);
    return out;
}

ScatterSample sample_scatter(const Interaction& at, Lobes lobes, RandomSequence& random)
{
    if (at.phase != nullptr)
        return sample_in_medium(at, lobes, random);
    if (const PlacedLobe* lobe = at.bsdf().single(lobes)) {
        ScatterSample out;
        if (with_diffuse_alone(at, *lobe, [&](const auto& diffuse) {
                out = sample_scatter_by_diffuse(at, diffuse, random);
            }))
            return out;
        out = {sample_below(at, *lobe, random)};
        if (!is_black(out.weight))
            out.pdf = pdf_of(at, *lobe, out.direction);
        return out;
    }
    const LobeProbabilities probabilities(at, lobes);
    if (!(probabilities.sum > 0))
        return {};
    const std::size_t picked = probabilities.pick(random.next());
    ScatterSample out{sample_below(at, at.bsdf().all[picked], random)};
    if (is_black(out.weight))
        return out;
    const Scattered there = scattered_by_set(at, out.direction, probabilities);
    out.pdf = there.pdf;
    out.weight = there.pdf > 0 ? there.value * (out.eta * out.eta / there.pdf) : Rgb(0);
    return out;
}

Rgb scattered_share(const Interaction& at, Lobes lobes)
{
    Rgb share(0.0f);
    for (const PlacedLobe& lobe : at.bsdf().lobes())
        if (lobe.handled == lobes)
            share += albedo_of(at, lobe);
    return share;
}

float followed_peak(const Interaction& at)
{
    Interaction facing = at;
    facing.back = facing.normal = facing.shading_normal;
    facing.cosine = 1;
    return scattered(facing, facing.back, Lobes::followed).pdf;
}

SpecularLobes specular_lobes(const Interaction& at)
{
    SpecularLobes out;
    const Bsdf& bsdf = at.bsdf();
    if (!bsdf.is_specular)
        return out;
    for (const PlacedLobe& lobe : bsdf.lobes()) {
        if (lobe.handled != Lobes::specular)
            continue;
        SpecularLobes one = specular(lobe.lobe, view_of(at, lobe.depth));
        if (bsdf.layers.any)
            one.mirror *=
                transmitted_by(bsdf.layers, lobe.depth, at.seen()) *
                transmitted_by(bsdf.layers, lobe.depth,
                               incidence(at, reflect(at.back, at.shading_normal), at.cosine));
        out.mirror += one.mirror;
        out.transmit += one.transmit;
        if (lobe.transmits)
            out.eta = one.eta;
    }
    return out;
}

Ray scattered_ray(const Interaction& at, const LobeSample& sample)
{
    return ray_from(at.point, sample.direction);
}

} // namespace hipmap
