#include "render/shading/energy_compensation.h"

#include "common/math/sampling.h"
#include "render/shading/glossy_albedo.h"

namespace hipmap {

namespace {

/// Of light along one direction, what facets that absorb nothing lose.
float lost(float cosine, float alpha)
{
    return 1 - glossy_albedo(cosine, alpha).white();
}

float average_lost(float alpha)
{
    return 1 - average_glossy_albedo(alpha).white();
}

} // namespace

Rgb regained_by(const Rgb& color, float alpha)
{
    const float loss = average_lost(alpha);
    if (!(loss > 0))
        return Rgb(0);
    const Rgb average = color + (1.0f - color) * (1.0f / 21);
    return average * average * (1 - loss) / (1.0f - average * loss) / (kPi * loss);
}

Rgb regained_lobe(const Bsdf& bsdf, float cos_in, float cos_out)
{
    return bsdf.regained * (lost(cos_in, bsdf.alpha) * lost(cos_out, bsdf.alpha));
}

Rgb regained_albedo(const Bsdf& bsdf, float cosine)
{
    return bsdf.regained * (lost(cosine, bsdf.alpha) * average_lost(bsdf.alpha) * kPi);
}

} // namespace hipmap
