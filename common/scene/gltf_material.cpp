#include "common/scene/gltf_material.h"

#include "common/scene/gltf_extras.h"
#include "common/scene/gltf_factors.h"
#include "common/scene/gltf_specular_glossiness.h"
#include "common/scene/gltf_texture.h"
#include "common/scene/gltf_volume.h"
#include "common/scene/scene_names.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hipmap {

namespace {

using nlohmann::json;

/// What Cycles shows where a face has no material.
constexpr float kBlenderGrey = 0.8f;

void read_extensions(const json& material, FactorReader& read, Material& out)
{
    const json& transmission = extension(material, "KHR_materials_transmission");
    out.transmission = read.fraction(transmission, "transmissionFactor", 0.0);
    const double ior = read.number(extension(material, "KHR_materials_ior"), "ior", 1.5);
    if (!(ior >= 1) && ior != 0)
        read.fail("its index of refraction must be 1 or more");
    out.ior = ior == 0 ? kInfiniteIor : static_cast<float>(ior);
    const json& specular = extension(material, "KHR_materials_specular");
    out.specular = read.fraction(specular, "specularFactor", 1.0);
    const glm::dvec3 colour = read.colour(specular, "specularColorFactor", 1.0);
    if (!(colour.x >= 0 && colour.y >= 0 && colour.z >= 0))
        read.fail("its specular colour must not be negative");
    out.specular_color = Rgb(colour);
    read_volume(material, read, out);
}

/// Layers and effects that are read for renderers that know them.
void read_layers(const json& material, FactorReader& read, Material& out)
{
    const json& coat = extension(material, "KHR_materials_clearcoat");
    out.clearcoat = read.fraction(coat, "clearcoatFactor", 0.0);
    out.clearcoat_roughness = read.fraction(coat, "clearcoatRoughnessFactor", 0.0);
    const json& sheen = extension(material, "KHR_materials_sheen");
    out.sheen_color = read.fractions(sheen, "sheenColorFactor", 0.0);
    out.sheen_roughness = read.fraction(sheen, "sheenRoughnessFactor", 0.0);
    const json& through = extension(material, "KHR_materials_diffuse_transmission");
    out.diffuse_transmission = read.fraction(through, "diffuseTransmissionFactor", 0.0);
    out.diffuse_transmission_color = read.fractions(through, "diffuseTransmissionColorFactor");
    const json& anisotropy = extension(material, "KHR_materials_anisotropy");
    out.anisotropy = read.fraction(anisotropy, "anisotropyStrength", 0.0);
    out.anisotropy_rotation =
        static_cast<float>(read.number(anisotropy, "anisotropyRotation", 0.0));
    out.dispersion =
        read.at_least_zero(extension(material, "KHR_materials_dispersion"), "dispersion");
}

void read_alpha(const json& material, const json& base, FactorReader& read, Material& out)
{
    if (base.contains("baseColorFactor"))
        out.alpha = read.fraction_of(base["baseColorFactor"][3].get<double>(), "baseColorFactor");
    const std::string mode = material.value("alphaMode", std::string("OPAQUE"));
    if (mode == "MASK")
        out.alpha_mode = AlphaMode::mask;
    else if (mode == "BLEND")
        out.alpha_mode = AlphaMode::blend;
    out.alpha_cutoff = read.at_least_zero(material, "alphaCutoff", 0.5);
}

void read_emission(const json& material, FactorReader& read, Material& out)
{
    const double strength = read.number(extension(material, "KHR_materials_emissive_strength"),
                                        "emissiveStrength", 1.0);
    const glm::dvec3 emission = read.colour(material, "emissiveFactor", 0.0) * strength;
    if (!(emission.x >= 0 && emission.y >= 0 && emission.z >= 0))
        read.fail("its emission must not be negative");
    const double most = std::max({emission.x, emission.y, emission.z});
    using Limits = std::numeric_limits<float>;
    if ((most > 0 && most < Limits::min()) || most > Limits::max())
        read.fail("its emission must be 0 or from 1.2e-38 to 3.4e38 W/(m2 sr)");
    out.emission = Rgb(emission);
}

Material read_material(const json& material, FactorReader& read)
{
    static const json kNothing = json::object();
    const auto found = material.find("pbrMetallicRoughness");
    const json& base = found == material.end() ? kNothing : *found;
    Material out;
    out.base_color = read.fractions(base, "baseColorFactor");
    out.metallic = read.fraction(base, "metallicFactor", 1.0);
    out.roughness = read.fraction(base, "roughnessFactor", 1.0);
    out.double_sided = material.value("doubleSided", false);
    read_emission(material, read, out);
    read_extensions(material, read, out);
    read_layers(material, read, out);
    read_alpha(material, base, read, out);
    read_specular_glossiness(material, read, out);
    return out;
}

/// An unlit material shows its colour whatever the light: it emits and reflects nothing.
void make_unlit(Material& material)
{
    material.unlit = true;
    material.reflection_model = ReflectionModel::metallic_roughness;
    std::erase_if(material.textures, [](const TextureSlot& slot) {
        return slot.use != TextureUse::base_color; // which stays for its alpha
    });
    if (!material.textures.empty()) {
        material.textures.push_back(material.textures[0]);
        material.textures[1].use = TextureUse::emission;
    }
    material.emission = material.base_color;
    material.base_color = Rgb(0.0f);
    material.metallic = 0.0f;
    material.specular = 0.0f;
    material.transmission = 0.0f;
    material.diffuse_transmission = 0.0f;
}

bool looks_lost(const json& material)
{
    const auto base = material.find("pbrMetallicRoughness");
    return base != material.end() && base->empty() && !material.contains("emissiveFactor") &&
           !material.contains("extensions");
}

void note_materials(const std::vector<std::string>& unlit, const std::vector<std::string>& lost,
                    SceneAudit& audit)
{
    if (!unlit.empty())
        audit.assumed.push_back("unlit (KHR_materials_unlit): " + list_names(unlit) +
                                " emit their base colour and reflect nothing");
    if (!lost.empty())
        audit.warnings.push_back(
            "white metal: " + list_names(lost) +
            (lost.size() == 1 ? " looks like a node material" : " look like node materials") +
            " lost in export; only the Principled BSDF is "
            "exported from Blender (not Diffuse, Glass, Glossy BSDF)");
}

} // namespace

Material gltf_default_material(Look look)
{
    Material material;
    material.name = "(no material)";
    if (!is_blender(look))
        return material;
    material.base_color = Rgb(kBlenderGrey);
    material.metallic = 0;
    material.specular = 0;
    return material;
}

void read_gltf_materials(const GltfDocument& document, const tinygltf::Model& model,
                         RawScene& scene)
{
    const auto materials = document.json.find("materials");
    if (materials == document.json.end())
        return;
    GltfTextureReader textures(document, model, scene);
    std::vector<std::string> unlit, lost;
    for (const json& material : *materials) {
        std::string name = clean_name(material.value("name", std::string()));
        if (name.empty())
            name = "material " + std::to_string(scene.materials.size());
        FactorReader read(scene, name);
        Material out = read_material(material, read);
        shade_like(scene.look, out);
        out.name = name;
        out.textures = textures.read(material, name);
        read_material_extras(material, out, scene);
        if (has_extension(material, "KHR_materials_unlit")) {
            make_unlit(out);
            unlit.push_back(name);
        }
        if (looks_lost(material))
            lost.push_back(name);
        if (!read.clamped.empty())
            scene.audit.warnings.push_back("material " + quote_name(name) + ": " +
                                           list_names(read.clamped) +
                                           " is outside 0 to 1 and was clamped");
        scene.materials.push_back(std::move(out));
    }
    note_materials(unlit, lost, scene.audit);
}

} // namespace hipmap
