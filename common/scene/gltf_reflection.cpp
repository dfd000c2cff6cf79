#include "common/scene/gltf_reflection.h"

#include "common/scene/reflection_models.h"
#include "common/scene/scene_names.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace hipmap {

namespace {

using nlohmann::json;

const ReflectionModelName& model_named(const std::string& name, const HipmapExtras& extras)
{
    for (const ReflectionModelName& named : kNamedReflectionModels)
        if (name == named.key)
            return named;
    extras.fail("reflection", R"(must be "phong", "schlick", "ward" or "lafortune")");
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

/// A key and the models that have it.
struct ModelKey {
    const char* key;
    std::vector<ReflectionModel> models;
    bool required = true; ///< a material of these models must have it
};

std::string quoted_keys(const std::vector<ReflectionModel>& models)
{
    std::string out;
    for (const ReflectionModelName& named : kNamedReflectionModels)
        if (std::find(models.begin(), models.end(), named.model) != models.end())
            out += (out.empty() ? "\"" : " or \"") + std::string(named.key) + "\"";
    return out;
}

/// Throws InputError if the key is there without its model, or the model without its key.
void check_key(const HipmapExtras& extras, const ModelKey& of, bool given, ReflectionModel model)
{
    const bool used = std::find(of.models.begin(), of.models.end(), model) != of.models.end();
    if (given && !used)
        extras.fail(of.key, "needs \"reflection\": " + quoted_keys(of.models));
    if (used && of.required && !given)
        extras.fail("reflection",
                    quoted_keys({model}) + " needs \"" + std::string(of.key) + "\" too");
}

void read_exponent(HipmapExtras& extras, Material& material)
{
    const std::optional<double> exponent = extras.positive("exponent");
    check_key(extras, {"exponent", {ReflectionModel::phong, ReflectionModel::lafortune}},
              exponent.has_value(), material.reflection_model);
    if (exponent)
        material.lobe_exponent =
            static_cast<float>(std::min<double>(*exponent, std::numeric_limits<float>::max()));
}

void read_specular(HipmapExtras& extras, Material& material)
{
    const std::optional<glm::dvec3> specular = extras.positive_triple("specular");
    check_key(
        extras,
        {"specular", {ReflectionModel::phong, ReflectionModel::ward, ReflectionModel::lafortune}},
        specular.has_value(), material.reflection_model);
    if (!specular)
        return;
    if (std::max({specular->x, specular->y, specular->z}) > 1)
        extras.fail("specular", "must be three numbers from 0 to 1");
    material.lobe_specular = Rgb(*specular);
}

void read_isotropy(HipmapExtras& extras, Material& material)
{
    const std::optional<double> isotropy = extras.positive("isotropy");
    check_key(extras, {"isotropy", {ReflectionModel::schlick}, false}, isotropy.has_value(),
              material.reflection_model);
    if (isotropy && !(*isotropy > 0 && *isotropy <= 1))
        extras.fail("isotropy", "must be above 0, and 1 at most");
    material.isotropy = static_cast<float>(isotropy.value_or(1.0));
}

void read_slopes(HipmapExtras& extras, Material& material)
{
    const std::optional<std::vector<double>> slopes = extras.numbers("slopes", 2, 1);
    check_key(extras, {"slopes", {ReflectionModel::ward}}, slopes.has_value(),
              material.reflection_model);
    if (!slopes)
        return;
    if (!(std::min(slopes->at(0), slopes->at(1)) > 0))
        extras.fail("slopes", "must be two numbers above 0, and 1 at most");
    material.ward_slopes =
        glm::max(glm::vec2(slopes->at(0), slopes->at(1)), std::numeric_limits<float>::min());
}

void read_coefficients(HipmapExtras& extras, Material& material)
{
    const std::optional<std::vector<double>> read = extras.numbers("coefficients", 3, 1);
    check_key(extras, {"coefficients", {ReflectionModel::lafortune}}, read.has_value(),
              material.reflection_model);
    if (!read)
        return;
    const glm::dvec3 factors(read->at(0), read->at(1), read->at(2));
    const double largest = std::max({std::abs(factors.x), std::abs(factors.y), factors.z});
    if (!(factors.z >= 0 && largest > 0))
        extras.fail("coefficients", "must be three numbers from -1 to 1: the third 0 or more, and "
                                    "one of them not 0");
    material.lafortune_coefficients = glm::vec3(factors / largest);
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
        return model == ReflectionModel::schlick;
    case TextureUse::anisotropy: // for its direction
        return model != ReflectionModel::phong;
    default:
        return false;
    }
}

/// Names of what the file says of the material that the model does not use.
std::vector<std::string> unused_keys(const json& from, ReflectionModel model)
{
    std::vector<std::string> out;
    const auto base = from.find("pbrMetallicRoughness");
    if (base != from.end()) {
        if (base->value("metallicFactor", 0.0) > 0)
            out.emplace_back("metallicFactor");
        for (const char* key : {"roughnessFactor", "metallicRoughnessTexture"})
            if (!has_use(model, TextureUse::metallic_roughness) && base->contains(key))
                out.emplace_back(key);
    }
    const auto extensions = from.find("extensions");
    if (extensions == from.end())
        return out;
    for (const char* name : {"transmission", "ior", "specular", "volume", "clearcoat", "sheen",
                             "diffuse_transmission", "dispersion", "anisotropy"}) {
        const std::string key = std::string("KHR_materials_") + name;
        const bool for_direction =
            has_use(model, TextureUse::anisotropy) && key == "KHR_materials_anisotropy";
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
    const ReflectionModelName* const named = name ? &model_named(*name, extras) : nullptr;
    if (named != nullptr)
        material.reflection_model = named->model;
    read_exponent(extras, material);
    read_specular(extras, material);
    read_isotropy(extras, material);
    read_slopes(extras, material);
    read_coefficients(extras, material);
    if (named == nullptr)
        return;
    if (!material.boundary)
        extras.fail("reflection", R"(does not apply with "boundary": false)");
    take_away_layers(material);
    const std::vector<std::string> unused = unused_keys(from, material.reflection_model);
    if (!unused.empty())
        audit.assumed.push_back("material " + quote_name(material.name) + " reflects by " +
                                named->author + "'s model, which ignores its " +
                                list_names(unused));
}

} // namespace hipmap
