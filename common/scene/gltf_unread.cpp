#include "common/scene/gltf_unread.h"

#include "common/scene/scene_names.h"

#include <algorithm>
#include <map>
#include <set>
#include <string_view>

namespace hipmap {

namespace {

using nlohmann::json;
using std::string_view;

constexpr string_view kRead[] = {
    "KHR_lights_punctual",          "KHR_materials_emissive_strength",
    "KHR_materials_transmission",   "KHR_materials_ior",
    "KHR_materials_specular",       "KHR_materials_volume",
    "KHR_materials_volume_scatter", "KHR_materials_clearcoat",
    "KHR_materials_unlit",          "KHR_mesh_quantization",
    "KHR_draco_mesh_compression",   "EXT_meshopt_compression",
    "EXT_mesh_gpu_instancing",      "KHR_texture_transform",
    "KHR_materials_sheen",          "KHR_materials_dispersion",
    "KHR_materials_anisotropy",     "KHR_materials_diffuse_transmission",
    "KHR_node_visibility",          "KHR_materials_pbrSpecularGlossiness",
};

constexpr string_view kRenderedTextures[] = {"baseColorTexture",
                                             "metallicRoughnessTexture",
                                             "transmissionTexture",
                                             "emissiveTexture",
                                             "normalTexture",
                                             "diffuseTexture",
                                             "specularGlossinessTexture",
                                             "specularTexture",
                                             "specularColorTexture",
                                             "clearcoatTexture",
                                             "clearcoatRoughnessTexture",
                                             "clearcoatNormalTexture",
                                             "sheenColorTexture",
                                             "sheenRoughnessTexture",
                                             "anisotropyTexture",
                                             "diffuseTransmissionTexture",
                                             "diffuseTransmissionColorTexture"};

/// Read, but of no use to a renderer that follows light.
constexpr string_view kNeedlessTextures[] = {"occlusionTexture", "thicknessTexture"};

/// Not read, but a scene without them keeps its shapes and lights: a warning is enough.
constexpr string_view kSpared[] = {
    "KHR_texture_basisu",        "EXT_texture_webp",       "EXT_texture_avif",
    "KHR_materials_iridescence", "KHR_materials_variants", "KHR_xmp_json_ld",
    "KHR_animation_pointer",
};

struct Cure {
    string_view extension;
    const char* cure;
};

constexpr Cure kCures[] = {
    {"KHR_meshopt_compression", "export without compression"},
};

template <typename List>
bool is_in(const List& list, string_view name)
{
    return std::find(std::begin(list), std::end(list), name) != std::end(list);
}

std::string name_of(const json& thing, const char* kind, std::size_t index)
{
    const auto name = thing.find("name");
    if (name != thing.end() && name->is_string() && !name->get_ref<const std::string&>().empty())
        return name->get<std::string>();
    return std::string(kind) + " " + std::to_string(index);
}

/// Kinds of unread things, each with the names it was seen on.
class UnreadThings {
  public:
    void add(const std::string& kind, const std::string& name)
    {
        names_["not read yet: " + kind].push_back(name);
    }

    void add_unrendered(const std::string& kind, const std::string& name)
    {
        names_["read but not rendered yet: " + kind].push_back(name);
    }

    /// key: of anything in a material.
    void add_texture(const std::string& key, const std::string& material)
    {
        if (is_in(kNeedlessTextures, key))
            needless_[key].push_back(material);
        else if (key.ends_with("Texture") && !is_in(kRenderedTextures, key))
            add_unrendered("textures: " + key + " of materials", material);
    }

    void add_colours(const std::string& name) { colours_.push_back(name); }

    void warn(SceneAudit& audit) const
    {
        for (const auto& [kind, names] : needless_)
            audit.assumed.push_back(kind + " of materials (" + list_names(names) +
                                    ") is ignored: shadows and thicknesses follow the "
                                    "shapes");
        if (!colours_.empty())
            audit.assumed.push_back("vertex colours (COLOR_0) of meshes (" + list_names(colours_) +
                                    ") multiply the base colour, as in glTF; to ignore them, "
                                    "render with --effects -vertex-colours");
        for (const auto& [kind, names] : names_)
            audit.warnings.push_back(kind +
                                     (names[0].empty() ? "" : " (" + list_names(names) + ")"));
    }

    bool mentions(const std::string& text) const
    {
        return std::any_of(names_.begin(), names_.end(), [&](const auto& entry) {
            return entry.first.find(text) != std::string::npos;
        });
    }

  private:
    std::map<std::string, std::vector<std::string>> names_, needless_;
    std::vector<std::string> colours_;
};

const json& members(const json& object, const char* key)
{
    static const json kNothing = json::object();
    const auto found = object.find(key);
    return found == object.end() ? kNothing : *found;
}

void collect_materials(const json& root, UnreadThings& unread)
{
    std::size_t index = 0;
    for (const json& material : members(root, "materials")) {
        const std::string name = name_of(material, "material", index++);
        for (const json* holder : {&material, &members(material, "pbrMetallicRoughness")})
            for (const auto& [key, value] : holder->items())
                unread.add_texture(key, name);
        for (const auto& [key, value] : members(material, "extensions").items()) {
            if (!is_in(kRead, key))
                unread.add(clean_name(key) + " of materials", name);
            for (const auto& [slot, texture] : value.items())
                if (is_in(kRead, key))
                    unread.add_texture(slot, name);
        }
    }
}

void collect_meshes(const json& root, UnreadThings& unread)
{
    std::size_t index = 0;
    for (const json& mesh : members(root, "meshes")) {
        const std::string name = name_of(mesh, "mesh", index++);
        for (const json& primitive : mesh["primitives"]) {
            if (primitive.value("mode", 4) < 4)
                unread.add("points and lines of meshes", name);
            for (const auto& [key, value] : primitive["attributes"].items())
                if (key == "COLOR_0")
                    unread.add_colours(name);
                else if (key != "POSITION" && key != "NORMAL" && key != "TANGENT" &&
                         !key.starts_with("TEXCOORD_") && !key.starts_with("JOINTS_") &&
                         !key.starts_with("WEIGHTS_"))
                    unread.add("attribute " + clean_name(key) + " of meshes", name);
        }
    }
}

void collect_nodes(const json& root, UnreadThings& unread)
{
    std::size_t index = 0;
    for (const json& node : members(root, "nodes")) {
        const std::string name = name_of(node, "node", index++);
        for (const auto& [key, value] : members(node, "extensions").items())
            if (!is_in(kRead, key))
                unread.add(clean_name(key) + " of objects", name);
    }
    index = 0;
    const json& lights = members(members(root, "extensions"), "KHR_lights_punctual");
    for (const json& light : members(lights, "lights")) {
        if (light.contains("range"))
            unread.add("range (custom distance) of lights", name_of(light, "light", index));
        ++index;
    }
}

const char* cure_for(string_view extension)
{
    for (const Cure& known : kCures)
        if (known.extension == extension)
            return known.cure;
    return "export without it";
}

} // namespace

void check_required_extensions(const GltfDocument& document)
{
    for (const json& required : members(document.json, "extensionsRequired")) {
        const auto& name = required.get_ref<const std::string&>();
        if (is_in(kRead, name) || is_in(kSpared, name))
            continue;
        throw scene_error(document.path, "extensionsRequired",
                          "extension " + quote_name(name) + " is not read; " + cure_for(name));
    }
}

void warn_of_unread_gltf(const GltfDocument& document, SceneAudit& audit)
{
    UnreadThings unread;
    collect_materials(document.json, unread);
    collect_meshes(document.json, unread);
    collect_nodes(document.json, unread);
    for (const json& used : members(document.json, "extensionsUsed")) {
        const auto& name = used.get_ref<const std::string&>();
        if (!is_in(kRead, name) && !unread.mentions(name))
            unread.add("extension " + clean_name(name), "");
    }
    unread.warn(audit);
}

} // namespace hipmap
