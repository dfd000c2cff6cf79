#include "render/shading/photon_lobes.h"

#include "render/shading/lobe_value.h"

namespace hipmap {

void PhotonLobes::look_through_layers()
{
    seen_.fill(Rgb(1));
    if (bsdf_.layers.any)
        for (const Depth depth : {Depth::sheen, Depth::reflection, Depth::diffuse})
            seen_[static_cast<std::size_t>(depth)] =
                transmitted_by(bsdf_.layers, depth, at_.seen());
    const Rgb& diffuse = seen_[static_cast<std::size_t>(Depth::diffuse)];
    base_ *= diffuse;
    if (bsdf_.transmits_diffusely)
        behind_ = bsdf_.diffuse_transmitted / kPi * diffuse;
}

Rgb PhotonLobes::reflected(const PlacedLobe& lobe, const glm::vec3& in, float cosine) const
{
    const LobeView& view = lobe.depth == Depth::clearcoat ? view_of(at_, lobe.depth) : view_;
    Rgb value(0.0f);
    if (glm::dot(view.normal, in) > 0)
        value = value_of(at_, lobe, view, in);
    // A photon of a face beside may come from below this one: nothing is folded to there.
    if (view.normal != at_.normal && lobe.folds && glm::dot(at_.normal, in) > 0) {
        const glm::vec3 below = mirrored(in, at_.normal);
        if (glm::dot(view.normal, below) > 0)
            value += value_of(at_, lobe, view, below);
    }
    return value * (seen_[static_cast<std::size_t>(lobe.depth)] / cosine);
}

Rgb PhotonLobes::transmitted(const glm::vec3& in, float cosine) const
{
    return cosine > 0 && glm::dot(at_.normal, in) < 0
               ? behind_ * transmitted_by(bsdf_.layers, Depth::diffuse, incidence(at_, -in, cosine))
               : Rgb(0);
}

Rgb PhotonLobes::of_all(const glm::vec3& in, float cosine) const
{
    Rgb value(0.0f);
    for (const PlacedLobe& lobe : bsdf_.lobes())
        if (lobe.handled == handled_ && !lobe.transmits)
            value += reflected(lobe, in, cosine);
    return value;
}

} // namespace hipmap
