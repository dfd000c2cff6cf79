#include "render/shading/interface_index.h"

#include <algorithm>

namespace hipmap {

namespace {

/// What light travels in on one side of a surface.
struct Dielectric {
    float ior = 1.0f;
    float dispersion = 0.0f;

    float index(float nanometres) const
    {
        return dispersion > 0 ? dispersed_index(ior, dispersion, nanometres) : ior;
    }
};

Dielectric dielectric_in(const RenderScene& scene, const MediumStack& inside)
{
    const MaterialId material = dielectric_at(*scene.media, inside);
    if (material == kNone)
        return {};
    const Material& of = scene.scene.materials[material];
    return {of.ior, of.dispersion};
}

/// Before the front of a face, and behind it: its own, where a ray leaves what it has not entered.
struct Sides {
    Dielectric front, behind;
};

Sides sides_of(const RenderScene& scene, const Interaction& at)
{
    Sides out{{}, {at.bsdf().ior, at.bsdf().dispersion}};
    const MediumStack& here = *at.inside;
    MediumStack behind = here;
    cross(*scene.media, at.point.face, at.front, behind);
    out.front = dielectric_in(scene, at.front ? here : behind);
    if (behind.count != here.count)
        out.behind = dielectric_in(scene, at.front ? behind : here);
    return out;
}

/// Keeps rough glass of nearly the index of its surroundings a surface.
float kept_apart(float ratio)
{
    return ratio < 1 ? std::min(ratio, 1 / kLeastRoughIndex) : std::max(ratio, kLeastRoughIndex);
}

void find_nested_index(const RenderScene& scene, Interaction& at, float& nanometres, Rgb& carried,
                       RandomSequence& random)
{
    const Sides sides = sides_of(scene, at);
    if (sides.front.dispersion > 0 || sides.behind.dispersion > 0)
        choose_wavelength(nanometres, carried, random);
    const float ratio = sides.behind.index(nanometres) / sides.front.index(nanometres);
    at.ior = at.bsdf().rough_glass ? kept_apart(ratio) : ratio;
}

} // namespace

void find_index_here(const RenderScene& scene, Interaction& at, float& nanometres, Rgb& carried,
                     RandomSequence& random)
{
    if (at.solid && at.bsdf().transmits && scene.has_nested())
        find_nested_index(scene, at, nanometres, carried, random);
    else
        disperse(at, nanometres, carried, random);
}

} // namespace hipmap
