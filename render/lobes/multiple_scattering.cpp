#include "render/lobes/multiple_scattering.h"

#include "common/math/sampling.h"
#include "render/lobes/glossy_albedo.h"

namespace hipmap {

namespace {

/// Returns the share of light along one direction that facets which absorb nothing lose.
float lost(float cosine, float alpha)
{
    return 1 - glossy_albedo(cosine, alpha).white();
}

float average_lost(float alpha)
{
    return 1 - average_glossy_albedo(alpha).white();
}

} // namespace

Rgb multiple_factor(const Rgb& color, float alpha)
{
    const float loss = average_lost(alpha);
    if (!(loss > 0))
        return Rgb(0);
    const Rgb average = color + (1.0f - color) * (1.0f / 21);
    return average * average * (1 - loss) / (1.0f - average * loss) / (kPi * loss);
}

Rgb multiple_scattering(const Rgb& factor, float cos_in, float cos_out, float alpha)
{
    return factor * (lost(cos_in, alpha) * lost(cos_out, alpha));
}

Rgb multiple_albedo(const Rgb& factor, float cosine, float alpha)
{
    return factor * (lost(cosine, alpha) * average_lost(alpha) * kPi);
}

} // namespace hipmap
