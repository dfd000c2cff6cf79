#include "experiments/rivals/spread_lobes.h"

#include "common/math/sampling.h"

namespace hipmap {

namespace {

float pdf_of(const Interaction& at, const WaysOn& ways, const glm::vec3& in)
{
    float out = 0;
    if (ways.gathered > 0)
        out += ways.gathered * scattered(at, in, Lobes::gathered).pdf;
    if (ways.followed > 0)
        out += ways.followed * scattered(at, in, Lobes::followed).pdf;
    return out;
}

/// Returns the pdf of drawing at.back as seen from `in`.
float reverse_pdf(const RenderScene& scene, const Interaction& at, const RayHit& hit,
                  const glm::vec3& in)
{
    if (at.is_diffuse() && at.shading_normal == at.normal)
        return at.cosine / kPi;
    Ray ray;
    ray.direction = -in;
    Interaction turned = interact(scene, ray, hit);
    turned.ior = at.ior;
    return pdf_of(turned, ways_on(turned), at.back);
}

} // namespace

WaysOn ways_on(const Interaction& at)
{
    WaysOn out;
    if (at.is_diffuse()) {
        out.gathered = is_black(at.bsdf().diffuse) ? 0.0f : 1.0f;
        return out;
    }
    out.specular = specular_lobes(at);
    if (at.gathers())
        out.gathered = max_channel(scattered_share(at, Lobes::gathered));
    if (at.follows())
        out.followed = max_channel(scattered_share(at, Lobes::followed));
    out.mirror = max_channel(out.specular.mirror);
    out.transmit = max_channel(out.specular.transmit);
    const float sum = out.gathered + out.followed + out.mirror + out.transmit;
    for (float* part : {&out.gathered, &out.followed, &out.mirror, &out.transmit})
        *part = sum > 0 ? *part / sum : 0;
    return out;
}

SpreadValue spread_value(const RenderScene& scene, const Interaction& at, const WaysOn& ways,
                         const RayHit& hit, const glm::vec3& in)
{
    SpreadValue out;
    for (const Lobes lobes : {Lobes::gathered, Lobes::followed}) {
        const float probability = lobes == Lobes::gathered ? ways.gathered : ways.followed;
        if (!(probability > 0))
            continue;
        const Scattered one = scattered(at, in, lobes);
        out.value += one.value;
        out.pdf += probability * one.pdf;
    }
    if (out.pdf > 0 && !is_black(out.value))
        out.reverse = reverse_pdf(scene, at, hit, in);
    else
        out.value = Rgb(0);
    return out;
}

float particle_factor(const Interaction& at, const glm::vec3& in)
{
    const bool transmitted = at.bsdf().transmits && glm::dot(in, at.normal) < 0;
    const float eta = transmitted ? eta_behind(at) : 1;
    return eta * eta * particle_correction(at, in);
}

} // namespace hipmap
