#include "common/scene/gltf_attributes.h"

#include "common/scene/gltf_accessor.h"
#include "common/scene/raw_scene.h"

#include <algorithm>
#include <cmath>

namespace hipmap {

namespace {

using nlohmann::json;

void note_texture(const std::string& slot, const json& texture, WantedAttributes& wanted)
{
    std::size_t set = texture.value("texCoord", std::size_t{0});
    if (has_extension(texture, "KHR_texture_transform"))
        set = texture["extensions"]["KHR_texture_transform"].value("texCoord", set);
    if (set < wanted.uv.size())
        wanted.uv[set] = true;
    const bool has_directions =
        slot == "normalTexture" || slot == "clearcoatNormalTexture" || slot == "anisotropyTexture";
    wanted.tangents = wanted.tangents || has_directions;
}

void note_textures(const json& holder, WantedAttributes& wanted)
{
    for (const auto& [key, value] : holder.items())
        if (key.ends_with("Texture") && value.is_object())
            note_texture(key, value, wanted);
}

/// A material's reflection model may be anisotropic along tangents, docs/scene.md.
bool may_be_directed(const json& material)
{
    const auto extras = material.find("extras");
    if (extras == material.end() || !extras->is_object() || !extras->contains("hipmap"))
        return false;
    const json& own = (*extras)["hipmap"];
    // Of a text that is not read here, too much would only cost memory.
    const auto has = [&](const std::string& key) {
        return own.is_string()
                   ? own.get_ref<const std::string&>().find("\"" + key + "\"") != std::string::npos
                   : own.is_object() && own.contains(key);
    };
    return has("isotropy") || has("slopes") || has("coefficients");
}

/// The components of element `i` of 2, 3 or 4; what is missing is 1.
glm::dvec4 vector_at(const GltfAccessor& values, std::size_t i)
{
    switch (values.type()) {
    case TINYGLTF_TYPE_VEC2:
        return {values.vec2(i), 1.0, 1.0};
    case TINYGLTF_TYPE_VEC3:
        return {values.vec3(i), 1.0};
    default:
        return values.vec4(i);
    }
}

bool is_finite_vector(const glm::dvec4& v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w);
}

} // namespace

WantedAttributes find_wanted_attributes(const GltfDocument& document)
{
    WantedAttributes wanted;
    const auto materials = document.json.find("materials");
    for (std::size_t i = 0; materials != document.json.end() && i < materials->size(); ++i) {
        const json& material = (*materials)[i];
        note_textures(material, wanted);
        if (material.contains("pbrMetallicRoughness"))
            note_textures(material["pbrMetallicRoughness"], wanted);
        if (may_be_directed(material))
            wanted.tangents = wanted.uv[0] = true;
        if (!material.contains("extensions"))
            continue;
        for (const auto& [name, extension] : material["extensions"].items()) {
            if (name.starts_with("KHR_materials_")) // others are not checked
                note_textures(extension, wanted);
            if (name ==
                "KHR_materials_anisotropy") // along the tangents, else the first texture's right
                wanted.tangents = wanted.uv[0] = true;
        }
    }
    return wanted;
}

std::vector<glm::dvec4> read_vertex_values(const PrimitivePlace& at, const AttributeSource& from,
                                           const UsedVertices& used)
{
    const GltfAccessor values(at.model, from.accessor, at.path);
    const std::string place = at.place + "." + from.name;
    if (std::find(from.types.begin(), from.types.end(), values.type()) == from.types.end() ||
        values.component_type() == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT || values.size() != used.of)
        throw scene_error(at.path, place,
                          "is of a type or count that glTF does not allow; the file is "
                          "damaged, export it again");
    std::vector<glm::dvec4> out;
    out.reserve(used.vertices.size());
    for (const std::uint32_t vertex : used.vertices) {
        out.push_back(vector_at(values, vertex));
        if (!is_finite_vector(out.back()))
            throw scene_error(at.path, place + ", vertex " + std::to_string(vertex),
                              "is not finite; repair the mesh and export it again");
    }
    return out;
}

VertexAttributes read_attributes(const PrimitivePlace& at, const WantedAttributes& wanted,
                                 const UsedVertices& used)
{
    VertexAttributes out;
    const auto read = [&](const char* name, const std::vector<int>& types) {
        const auto found = at.primitive.attributes.find(name);
        return found == at.primitive.attributes.end()
                   ? std::vector<glm::dvec4>{}
                   : read_vertex_values(at, {name, found->second, types}, used);
    };
    constexpr std::array<const char*, 2> kUvNames = {"TEXCOORD_0", "TEXCOORD_1"};
    for (std::size_t set = 0; set < kUvNames.size(); ++set)
        if (wanted.uv[set])
            for (const glm::dvec4& uv : read(kUvNames[set], {TINYGLTF_TYPE_VEC2}))
                out.uv[set].emplace_back(uv);
    if (wanted.tangents)
        for (const glm::dvec4& tangent : read("TANGENT", {TINYGLTF_TYPE_VEC4}))
            out.tangents.emplace_back(tangent);
    for (const glm::dvec4& colour : read("COLOR_0", {TINYGLTF_TYPE_VEC3, TINYGLTF_TYPE_VEC4}))
        out.colours.emplace_back(glm::clamp(colour, 0.0, 1.0));
    return out;
}

} // namespace hipmap
