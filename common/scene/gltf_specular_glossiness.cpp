#include "common/scene/gltf_specular_glossiness.h"

#include <cmath>

namespace hipmap {

using nlohmann::json;

bool is_specular_glossy(const json& material)
{
    return has_extension(material, kSpecularGlossiness);
}

void read_specular_glossiness(const json& material, FactorReader& read, Material& out)
{
    if (!is_specular_glossy(material))
        return;
    const json& from = extension(material, kSpecularGlossiness);
    const bool has_texture = from.contains("specularGlossinessTexture");
    out.base_color = read.fractions(from, "diffuseFactor");
    out.alpha = from.contains("diffuseFactor")
                    ? read.fraction_of(from["diffuseFactor"][3].get<double>(), "diffuseFactor")
                    : 1.0f;
    out.metallic = 0;
    out.roughness = has_texture ? 1 : 1 - read.fraction(from, "glossinessFactor", 1.0);
    out.ior = kInfiniteIor;
    out.specular = 1;
    out.specular_color = read.fractions(from, "specularFactor");
}

TextureImage roughness_of_glossiness(const TextureImage& texture, float glossiness)
{
    TextureImage out = texture;
    out.name += " (roughness)";
    for (std::size_t pixel = 0; pixel < out.rgba.size(); pixel += 4) {
        const float rough = 255 - glossiness * static_cast<float>(texture.rgba[pixel + 3]);
        out.rgba[pixel] = out.rgba[pixel + 2] = 0;
        out.rgba[pixel + 1] = static_cast<std::uint8_t>(std::lround(rough));
        out.rgba[pixel + 3] = 255;
    }
    return out;
}

} // namespace hipmap
