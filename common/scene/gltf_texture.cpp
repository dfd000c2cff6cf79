#include "common/scene/gltf_texture.h"

#include "common/scene/gltf_buffers.h"
#include "common/scene/gltf_specular_glossiness.h"
#include "common/scene/scene_names.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hipmap {

namespace {

using nlohmann::json;

constexpr bool kColour = true; ///< sRGB; the others are linear
constexpr bool kLinear = false;

const json& member(const json& object, const char* key)
{
    static const json kNothing = json::object();
    const auto found = object.find(key);
    return found == object.end() ? kNothing : *found;
}

Wrap wrap_of(const json& sampler, const char* key)
{
    switch (sampler.value(key, 0u)) {
    case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE:
        return Wrap::clamp;
    case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT:
        return Wrap::mirror;
    default:
        return Wrap::repeat;
    }
}

Filter filter_of(const json& sampler, const char* key)
{
    switch (sampler.value(key, 0u)) {
    case TINYGLTF_TEXTURE_FILTER_NEAREST:
    case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST:
    case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_LINEAR:
        return Filter::nearest;
    default:
        return Filter::linear;
    }
}

/// KHR_texture_transform: scaled, turned, moved.  A positive angle turns the coordinates
/// counter-clockwise as one sees them on the texture, whose v runs downwards.
glm::mat3x2 uv_transform_of(const json& transform)
{
    const json offset = transform.value("offset", json{0, 0});
    const json scale = transform.value("scale", json{1, 1});
    const double angle = transform.value("rotation", 0.0);
    const double c = std::cos(angle), s = std::sin(angle);
    const double u = scale[0].get<double>(), v = scale[1].get<double>();
    return {glm::vec2(c * u, -s * u), glm::vec2(s * v, c * v),
            glm::vec2(offset[0].get<double>(), offset[1].get<double>())};
}

} // namespace

/// Where a texture stands in a material, and what it is for.
struct GltfTextureReader::SlotKind {
    const char* holder; ///< "": the material itself
    const char* key;
    TextureUse use;
    bool srgb;
};

const GltfTextureReader::SlotKind GltfTextureReader::kSlotKinds[] = {
    {"pbrMetallicRoughness", "baseColorTexture", TextureUse::base_color, kColour},
    {"pbrMetallicRoughness", "metallicRoughnessTexture", TextureUse::metallic_roughness, kLinear},
    {"", "normalTexture", TextureUse::normal, kLinear},
    {"", "occlusionTexture", TextureUse::occlusion, kLinear},
    {"", "emissiveTexture", TextureUse::emission, kColour},
    {kSpecularGlossiness, "diffuseTexture", TextureUse::base_color, kColour},
    {kSpecularGlossiness, "specularGlossinessTexture", TextureUse::specular_color, kColour},
    {kSpecularGlossiness, "specularGlossinessTexture", TextureUse::metallic_roughness, kLinear},
    {"KHR_materials_transmission", "transmissionTexture", TextureUse::transmission, kLinear},
    {"KHR_materials_volume", "thicknessTexture", TextureUse::thickness, kLinear},
    {"KHR_materials_specular", "specularTexture", TextureUse::specular, kLinear},
    {"KHR_materials_specular", "specularColorTexture", TextureUse::specular_color, kColour},
    {"KHR_materials_clearcoat", "clearcoatTexture", TextureUse::clearcoat, kLinear},
    {"KHR_materials_clearcoat", "clearcoatRoughnessTexture", TextureUse::clearcoat_roughness,
     kLinear},
    {"KHR_materials_clearcoat", "clearcoatNormalTexture", TextureUse::clearcoat_normal, kLinear},
    {"KHR_materials_sheen", "sheenColorTexture", TextureUse::sheen_color, kColour},
    {"KHR_materials_sheen", "sheenRoughnessTexture", TextureUse::sheen_roughness, kLinear},
    {"KHR_materials_anisotropy", "anisotropyTexture", TextureUse::anisotropy, kLinear},
    {"KHR_materials_diffuse_transmission", "diffuseTransmissionTexture",
     TextureUse::diffuse_transmission, kLinear},
    {"KHR_materials_diffuse_transmission", "diffuseTransmissionColorTexture",
     TextureUse::diffuse_transmission_color, kColour},
};

std::vector<TextureSlot> GltfTextureReader::read(const json& material, const std::string& name)
{
    std::vector<TextureSlot> slots;
    for (const SlotKind& kind : kSlotKinds) {
        const std::string holder = kind.holder;
        const json& at = holder.empty() ? material
                         : holder.starts_with("KHR_")
                             ? member(member(material, "extensions"), kind.holder)
                             : member(material, kind.holder);
        if (!at.contains(kind.key) ||
            (holder == "pbrMetallicRoughness" && is_specular_glossy(material)))
            continue;
        std::optional<TextureSlot> slot = read_slot(kind, at[kind.key], name);
        if (!slot)
            continue;
        if (holder == kSpecularGlossiness && kind.use == TextureUse::metallic_roughness) {
            const auto made = add_roughness(slot->image, at.value("glossinessFactor", 1.0f));
            if (!made)
                continue;
            slot->image = *made;
        }
        slots.push_back(*slot);
    }
    return slots;
}

std::optional<std::uint32_t> GltfTextureReader::add_roughness(std::uint32_t image, float glossiness)
{
    const auto found = roughness_images_.find({image, glossiness});
    if (found != roughness_images_.end())
        return found->second;
    if (!store_.has_room_for(scene_.images[image], "glossiness of texture"))
        return std::nullopt;
    return roughness_images_[{image, glossiness}] = store_.add(
               roughness_of_glossiness(store_.copy_of(image), std::clamp(glossiness, 0.0f, 1.0f)));
}

std::optional<TextureSlot> GltfTextureReader::read_slot(const SlotKind& kind, const json& info,
                                                        const std::string& material)
{
    const std::string place = "material " + quote_name(material) + ", " + kind.key;
    const auto warn = [&](const std::string& what) {
        scene_.audit.warnings.push_back(place + " " + what + "; it is left out");
        return std::nullopt;
    };
    const json& transform = member(member(info, "extensions"), "KHR_texture_transform");
    const json& texture = document_.json["textures"][info["index"].get<std::size_t>()];
    TextureSlot slot;
    slot.use = kind.use;
    const auto set = transform.value("texCoord", info.value("texCoord", std::uint64_t{0}));
    if (set >= VertexAttributes().uv.size())
        return warn("uses TEXCOORD_" + std::to_string(set) + ", but only two sets are supported");
    slot.uv_set = static_cast<std::uint32_t>(set);
    slot.sampler = read_sampler(texture);
    slot.sampler.srgb = kind.srgb;
    slot.uv_transform = uv_transform_of(transform);
    slot.strength = static_cast<float>(info.value("scale", info.value("strength", 1.0)));
    if (!is_finite_transform(slot.uv_transform) || !std::isfinite(slot.strength))
        return warn("has a number that is too large");
    if (!texture.contains("source"))
        return warn("has no image in a supported format (PNG, JPEG)");
    const std::optional<std::uint32_t> image = image_of(texture["source"].get<std::size_t>());
    if (!image)
        return std::nullopt; // warned of, once for all textures that show it
    slot.image = *image;
    return slot;
}

Sampler GltfTextureReader::read_sampler(const json& texture) const
{
    Sampler out;
    if (!texture.contains("sampler"))
        return out;
    const json& sampler = document_.json["samplers"][texture["sampler"].get<std::size_t>()];
    out.wrap_u = wrap_of(sampler, "wrapS");
    out.wrap_v = wrap_of(sampler, "wrapT");
    out.magnify = filter_of(sampler, "magFilter");
    out.minify = filter_of(sampler, "minFilter");
    return out;
}

std::optional<std::uint32_t> GltfTextureReader::image_of(std::size_t index)
{
    images_.resize(document_.json["images"].size());
    if (!images_[index])
        images_[index].emplace(load_image(index));
    return *images_[index];
}

std::optional<std::uint32_t> GltfTextureReader::load_image(std::size_t index)
{
    const json& listed = document_.json["images"][index];
    std::string name = clean_name(listed.value("name", std::string()));
    if (name.empty())
        name = "image " + std::to_string(index);
    DecodedTexture texture;
    try {
        texture = store_.decode(encoded_bytes(index));
    } catch (const InputError& error) { // as of a buffer, but a scene can do without a texture
        const std::string line = error.what();
        const std::string prefix = scene_.path.string() + ": ";
        texture.problem =
            "cannot be read (" + line.substr(line.starts_with(prefix) ? prefix.size() : 0) + ")";
    }
    if (!texture.problem.empty()) {
        store_.warn(name, texture.problem);
        return std::nullopt;
    }
    texture.image.name = name;
    return store_.add(std::move(texture.image));
}

std::vector<unsigned char> GltfTextureReader::encoded_bytes(std::size_t index) const
{
    const json& image = document_.json["images"][index];
    const std::string place = "images[" + std::to_string(index) + "]";
    if (image.contains("uri"))
        return read_gltf_uri(document_, place, image["uri"].get<std::string>());
    if (!image.contains("bufferView"))
        throw scene_error(scene_.path, place, "has neither uri nor bufferView");
    const tinygltf::BufferView& view = model_.bufferViews[image["bufferView"].get<std::size_t>()];
    const auto& data = model_.buffers[static_cast<std::size_t>(view.buffer)].data;
    const auto first = data.begin() + static_cast<std::ptrdiff_t>(view.byteOffset);
    return {first, first + static_cast<std::ptrdiff_t>(view.byteLength)};
}

} // namespace hipmap
