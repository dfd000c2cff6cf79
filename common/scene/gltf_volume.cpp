#include "common/scene/gltf_volume.h"

#include <cmath>

namespace hipmap {

namespace {

using nlohmann::json;

/// An attenuation colour of zero would absorb without limit; this leaves a millionth.
constexpr double kDarkestAttenuation = 1e-6;

/// Beyond it the phase function is too narrow for float.
constexpr double kMostAnisotropy = 0.99;

/// What share of light a medium scatters each time, if so much of it comes back from a deep one:
/// docs/media.md (13).
double single_scattering_albedo(double colour, double g)
{
    const double root = std::sqrt(9.59217 + colour * (41.6808 + 17.7126 * colour));
    const double s = std::clamp(4.09712 + 4.20863 * colour - root, 0.0, 1.0);
    return (1 - s * s) / (1 - g * s * s);
}

void read_attenuation(const json& volume, FactorReader& read, Material& out)
{
    out.thickness = read.at_least_zero(volume, "thicknessFactor");
    if (!volume.contains("attenuationDistance"))
        return;
    const double distance = read.number(volume, "attenuationDistance", 0.0);
    if (!(distance > 0))
        read.fail("attenuationDistance must be above 0; set a density above 0");
    const Rgb colour = read.fractions(volume, "attenuationColor");
    for (int c = 0; c < 3; ++c) {
        const double depth = is_blender(read.look)
                                 ? 1.0 - colour[c]
                                 : -std::log(std::max<double>(colour[c], kDarkestAttenuation));
        out.absorption[c] = static_cast<float>(depth / distance);
    }
}

/// Scatters a part of what is taken away.
void read_scattering(const json& scatter, FactorReader& read, Material& out)
{
    const Rgb colour = read.fractions(scatter, "multiscatterColor", 0.0);
    const double g = read.number(scatter, "scatterAnisotropy", 0.0);
    if (!(std::abs(g) < 1))
        read.fail("scatterAnisotropy must be above -1 and below 1");
    out.phase = {g == 0 ? PhaseKind::isotropic : PhaseKind::henyey_greenstein,
                 static_cast<float>(std::clamp(g, -kMostAnisotropy, kMostAnisotropy))};
    for (int c = 0; c < 3; ++c) {
        const float extinction = out.absorption[c];
        out.scattering[c] =
            extinction * static_cast<float>(single_scattering_albedo(colour[c], out.phase.g));
        out.absorption[c] = extinction - out.scattering[c];
    }
}

} // namespace

void read_volume(const json& material, FactorReader& read, Material& out)
{
    read_attenuation(extension(material, "KHR_materials_volume"), read, out);
    const json& scatter = extension(material, "KHR_materials_volume_scatter");
    if (!scatter.empty())
        read_scattering(scatter, read, out);
}

} // namespace hipmap
