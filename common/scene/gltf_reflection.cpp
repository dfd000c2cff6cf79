#include "common/scene/gltf_reflection.h"

#include "common/scene/scene_names.h"

#include <algorithm>
#include <limits>

namespace hipmap {

namespace {

using nlohmann::json;

ReflectionModel model_named(const std::string& name, const HipmapExtras& extras)
{
    if (name == "phong")
        return ReflectionModel::phong;
    if (name != "schlick")
        extras.fail("reflection", R"(must be "phong" or "schlick")");
    return ReflectionModel::schlick;
}

DiffuseModel diffuse_named(const std::string& name, const HipmapExtras& extras)
{
    if (name == "burley")
        return DiffuseModel::burley;
    if (name == "oren-nayar")
        return DiffuseModel::oren_nayar;
    if (name != "lambert")
        extras.fail("diffuse", R"(must be "lambert", "burley" or "oren-nayar")");
    return DiffuseModel::lambert;
}

void read_phong(HipmapExtras& extras, Material& material)
{
    const std::optional<double> exponent = extras.positive("exponent");
    const std::optional<glm::dvec3> specular = extras.positive_triple("specular");
    if (material.reflection_model != ReflectionModel::phong) {
        if (exponent || specular)
            extras.fail(exponent ? "exponent" : "specular", R"(needs "reflection": "phong")");
        return;
    }
    if (!exponent || !specular)
        extras.fail("reflection", R"("phong" needs "exponent" and "specular" too)");
    if (std::max({specular->x, specular->y, specular->z}) > 1)
        extras.fail("specular", "must be three numbers from 0 to 1");
    material.phong_exponent =
        static_cast<float>(std::min<double>(*exponent, std::numeric_limits<float>::max()));
    material.phong_specular = Rgb(*specular);
}

void read_schlick(HipmapExtras& extras, Material& material)
{
    const std::optional<double> isotropy = extras.positive("isotropy");
    if (isotropy && material.reflection_model != ReflectionModel::schlick)
        extras.fail("isotropy", R"(needs "reflection": "schlick")");
    if (isotropy && !(*isotropy > 0 && *isotropy <= 1))
        extras.fail("isotropy", "must be above 0, and 1 at most");
    material.isotropy = static_cast<float>(isotropy.value_or(1.0));
}

/// Textures of what the model has.
bool has_use(ReflectionModel model, TextureUse use)
{
    switch (use) {
    case TextureUse::base_color:
    case TextureUse::normal:
    case TextureUse::emission:
    case TextureUse::occlusion:
        return true;
    case TextureUse::metallic_roughness:
    case TextureUse::anisotropy: // for its direction
        return model == ReflectionModel::schlick;
    default:
        return false;
    }
}

/// Names of what the file says of the material that the model does not use.
std::vector<std::string> unused_keys(const json& from, ReflectionModel model)
{
    const bool phong = model == ReflectionModel::phong;
    std::vector<std::string> out;
    const auto base = from.find("pbrMetallicRoughness");
    if (base != from.end()) {
        if (base->value("metallicFactor", 0.0) > 0)
            out.emplace_back("metallicFactor");
        for (const char* key : {"roughnessFactor", "metallicRoughnessTexture"})
            if (phong && base->contains(key))
                out.emplace_back(key);
    }
    const auto extensions = from.find("extensions");
    if (extensions == from.end())
        return out;
    for (const char* name : {"transmission", "ior", "specular", "volume", "clearcoat", "sheen",
                             "diffuse_transmission", "dispersion", "anisotropy"}) {
        const std::string key = std::string("KHR_materials_") + name;
        const bool for_direction = !phong && key == "KHR_materials_anisotropy";
        if (extensions->contains(key) && !for_direction)
            out.push_back(key);
    }
    return out;
}

void take_away_layers(Material& material)
{
    material.transmission = 0;
    material.clearcoat = 0;
    material.sheen_color = Rgb(0);
    material.diffuse_transmission = 0;
    std::erase_if(material.textures, [&](const TextureSlot& slot) {
        return !has_use(material.reflection_model, slot.use);
    });
}

} // namespace

void read_reflection(HipmapExtras& extras, const json& from, Material& material, SceneAudit& audit)
{
    const std::optional<std::string> name = extras.text("reflection");
    if (const std::optional<std::string> diffuse = extras.text("diffuse"))
        material.diffuse_model = diffuse_named(*diffuse, extras);
    if (name)
        material.reflection_model = model_named(*name, extras);
    read_phong(extras, material);
    read_schlick(extras, material);
    if (!name)
        return;
    if (!material.boundary)
        extras.fail("reflection", R"(does not apply with "boundary": false)");
    take_away_layers(material);
    const std::vector<std::string> unused = unused_keys(from, material.reflection_model);
    if (!unused.empty())
        audit.assumed.push_back("material " + quote_name(material.name) + " reflects by " +
                                (*name == "phong" ? "Phong's" : "Schlick's") +
                                " model, which ignores its " + list_names(unused));
}

} // namespace hipmap
