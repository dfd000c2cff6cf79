#include "render/shading/photon_lobes.h"

#include "render/shading/lobe_value.h"

#include <bit>

namespace hipmap {

void PhotonLobes::look_through_layers()
{
    const Bsdf& bsdf = lobes_.bsdf;
    lobes_.seen.fill(Rgb(1));
    if (bsdf.layers.any)
        for (const Depth depth : {Depth::sheen, Depth::reflection, Depth::diffuse})
            lobes_.seen[static_cast<std::size_t>(depth)] =
                transmitted_by(bsdf.layers, depth, at_.seen());
    const Rgb& diffuse = lobes_.seen[static_cast<std::size_t>(Depth::diffuse)];
    base_ *= diffuse;
    if (bsdf.transmits_diffusely)
        behind_ = bsdf.diffuse_transmitted / kPi * diffuse;
}

Rgb PhotonLobes::reflected(const PlacedLobe& lobe, const glm::vec3& in, float cosine) const
{
    const LobeView& view = lobe.depth == Depth::clearcoat ? view_of(at_, lobe.depth) : lobes_.view;
    Rgb value(0.0f);
    if (glm::dot(view.normal, in) > 0)
        value = value_of(at_, lobe, view, in);
    // A photon of a face beside may come from below this one: nothing is folded to there.
    if (view.normal != at_.normal && lobe.folds && glm::dot(at_.normal, in) > 0) {
        const glm::vec3 below = mirrored(in, at_.normal);
        if (glm::dot(view.normal, below) > 0)
            value += value_of(at_, lobe, view, below);
    }
    return value * (lobes_.seen[static_cast<std::size_t>(lobe.depth)] / cosine);
}

Rgb PhotonLobes::transmitted(const glm::vec3& in, float cosine) const
{
    return cosine > 0 && glm::dot(at_.normal, in) < 0
               ? behind_ *
                     transmitted_by(lobes_.bsdf.layers, Depth::diffuse, incidence(at_, -in, cosine))
               : Rgb(0);
}

Rgb PhotonLobes::of_all(const glm::vec3& in, float cosine) const
{
    Rgb value(0.0f);
    for (const PlacedLobe& lobe : lobes_.bsdf.lobes())
        if (lobe.handled == lobes_.handled && !lobe.transmits)
            value += reflected(lobe, in, cosine);
    return value;
}

void PhotonLobes::weigh(const DirectionBatch& in, std::size_t count, RgbBatch& out) const
{
    constexpr std::uint64_t kAll = ~std::uint64_t{0};
    std::uint64_t left =
        can_weigh_batch(lobes_) ? weigh_batch(lobes_, in, count, out) : kAll >> (kBatch - count);
    for (; left != 0; left &= left - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(left));
        out.set(lane, (*this)(in.at(lane)));
    }
}

} // namespace hipmap
