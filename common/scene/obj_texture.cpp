#include "common/scene/obj_texture.h"

#include "common/file/output_file.h"
#include "common/scene/height_map.h"
#include "common/scene/phong_exponent.h"
#include "common/scene/scene_file.h"
#include "common/scene/scene_names.h"

#include <algorithm>
#include <cmath>

namespace hipmap {

namespace {

/// tinyobjloader's Kd of a material that has a texture and no Kd, whose texture stands alone.
constexpr float kMissingKd = 0.6f;

/// OBJ's v runs upwards, ours downwards.
TextureSlot slot_of(TextureUse use, std::uint32_t image, const tinyobj::texture_option_t& option)
{
    const auto number = [](tinyobj::real_t value) { return static_cast<float>(value); };
    TextureSlot slot;
    slot.use = use;
    slot.image = image;
    slot.sampler.srgb = use == TextureUse::base_color || use == TextureUse::emission ||
                        use == TextureUse::specular_color;
    if (option.clamp)
        slot.sampler.wrap_u = slot.sampler.wrap_v = Wrap::clamp;
    const float scale_u = number(option.scale[0]), scale_v = number(option.scale[1]);
    const float v = 1 - scale_v - number(option.origin_offset[1]);
    slot.uv_transform = {glm::vec2(scale_u, 0), glm::vec2(0, scale_v),
                         glm::vec2(number(option.origin_offset[0]), v)};
    return slot;
}

void add_slot(const TextureSlot& slot, Material& out)
{
    if (is_finite_transform(slot.uv_transform))
        out.textures.push_back(slot);
}

/// The pixel of `of` at the place of a pixel of a texture of another size.
std::size_t nearest_pixel(const TextureImage& of, const TextureImage& like, int x, int y)
{
    const auto column = static_cast<std::size_t>(x) * static_cast<std::size_t>(of.width) /
                        static_cast<std::size_t>(like.width);
    const auto row = static_cast<std::size_t>(y) * static_cast<std::size_t>(of.height) /
                     static_cast<std::size_t>(like.height);
    return 4 * (row * static_cast<std::size_t>(of.width) + column);
}

/// Puts a channel of one texture, read at its nearest pixels, into a channel of another.
void copy_channel(const TextureImage& from, int from_channel, TextureImage& to, int to_channel)
{
    for (int y = 0; y < to.height; ++y)
        for (int x = 0; x < to.width; ++x)
            to.rgba[nearest_pixel(to, to, x, y) + static_cast<std::size_t>(to_channel)] =
                from.rgba[nearest_pixel(from, to, x, y) + static_cast<std::size_t>(from_channel)];
}

TextureImage white_image(const TextureImage& like)
{
    TextureImage out = like;
    std::fill(out.rgba.begin(), out.rgba.end(), std::uint8_t{255});
    return out;
}

/// Opacity maps are grey, or hold it in their alpha.
int opacity_channel(const TextureImage& image)
{
    return has_alpha(image) ? 3 : 0;
}

} // namespace

void ObjTextureReader::read(const tinyobj::material_t& mtl, bool by_blender, Material& out)
{
    read_colours(mtl, out);
    read_opacity(mtl, out);
    read_physical(mtl, out);
    read_exponents(mtl, by_blender, out);
    read_normals(mtl, out);
    collect_unread(mtl);
}

void ObjTextureReader::read_colours(const tinyobj::material_t& mtl, Material& out)
{
    const bool is_metal = out.metallic == 1; // of which the colour is Ks
    const std::string& base = is_metal ? mtl.specular_texname : mtl.diffuse_texname;
    if (const auto image = image_of(base)) {
        add_slot(slot_of(TextureUse::base_color, *image,
                         is_metal ? mtl.specular_texopt : mtl.diffuse_texopt),
                 out);
        if (!is_metal && (is_black(out.base_color) || out.base_color == Rgb(kMissingKd)))
            out.base_color = Rgb(1);
    }
    if (const auto image = is_metal ? std::nullopt : image_of(mtl.specular_texname))
        add_slot(slot_of(TextureUse::specular_color, *image, mtl.specular_texopt), out);
    if (const auto image = image_of(mtl.emissive_texname)) {
        add_slot(slot_of(TextureUse::emission, *image, mtl.emissive_texopt), out);
        if (is_black(out.emission))
            out.emission = Rgb(1);
    }
}

/// Opacity goes into the alpha of the base colour's texture.
void ObjTextureReader::read_opacity(const tinyobj::material_t& mtl, Material& out)
{
    const auto image = image_of(mtl.alpha_texname);
    if (!image)
        return;
    const auto base =
        std::find_if(out.textures.begin(), out.textures.end(),
                     [](const TextureSlot& slot) { return slot.use == TextureUse::base_color; });
    const TextureImage opacity = store_.copy_of(*image);
    TextureImage joined =
        base == out.textures.end() ? white_image(opacity) : store_.copy_of(base->image);
    copy_channel(opacity, opacity_channel(opacity), joined, 3);
    const auto made = add_image(std::move(joined));
    if (!made)
        return;
    if (base == out.textures.end())
        add_slot(slot_of(TextureUse::base_color, *made, mtl.alpha_texopt), out);
    else
        base->image = *made;
    out.alpha_mode = AlphaMode::blend;
    out.transmission = 0; // `d` is the factor of the map, not glass
}

/// Roughness and metallic share a texture, as in glTF.
void ObjTextureReader::read_physical(const tinyobj::material_t& mtl, Material& out)
{
    const auto rough = image_of(mtl.roughness_texname), metal = image_of(mtl.metallic_texname);
    if (rough || metal) {
        TextureImage joined = white_image(store_.copy_of(rough ? *rough : *metal));
        if (rough)
            copy_channel(store_.copy_of(*rough), 0, joined, 1);
        if (metal)
            copy_channel(store_.copy_of(*metal), 0, joined, 2);
        if (const auto made = add_image(std::move(joined))) {
            add_slot(slot_of(TextureUse::metallic_roughness, *made,
                             rough ? mtl.roughness_texopt : mtl.metallic_texopt),
                     out);
            out.roughness = rough && !(mtl.roughness > 0) ? 1 : out.roughness;
            out.metallic = metal && !(mtl.metallic > 0) ? 1 : out.metallic;
        }
    }
}

/// A texture of roughness for one of Phong exponents, which multiply Ns.
void ObjTextureReader::read_exponents(const tinyobj::material_t& mtl, bool by_blender,
                                      Material& out)
{
    const std::string& name = mtl.specular_highlight_texname;
    if (name.empty())
        return;
    const bool has_lobe = out.specular > 0 && out.transmission == 0 && out.metallic == 0;
    if (!has_lobe || mtl.roughness > 0 ||
        find_texture(out.textures, TextureUse::metallic_roughness) != nullptr) {
        unread_["map_Ns"].push_back(mtl.name);
        return;
    }
    const auto image = image_of(name);
    if (!image)
        return;
    TextureImage rough = store_.copy_of(*image);
    for (std::size_t i = 0; i < rough.rgba.size(); i += 4) {
        const float value = static_cast<float>(rough.rgba[i]) / 255;
        const float roughness =
            by_blender ? value : roughness_of_exponent(value * std::max(0.0, mtl.shininess));
        rough.rgba[i + 1] = static_cast<std::uint8_t>(std::lround(255 * roughness));
        rough.rgba[i] = rough.rgba[i + 2] = rough.rgba[i + 3] = 255;
    }
    if (const auto made = add_image(std::move(rough))) {
        add_slot(slot_of(TextureUse::metallic_roughness, *made, mtl.specular_highlight_texopt),
                 out);
        out.roughness = 1;
    }
}

void ObjTextureReader::read_normals(const tinyobj::material_t& mtl, Material& out)
{
    if (const auto image = image_of(mtl.normal_texname))
        add_slot(slot_of(TextureUse::normal, *image, mtl.normal_texopt), out);
    else
        read_bump(mtl, out);
}

/// Blender and others name normal maps map_Bump too.
void ObjTextureReader::read_bump(const tinyobj::material_t& mtl, Material& out)
{
    const auto image = image_of(mtl.bump_texname);
    if (!image)
        return;
    const tinyobj::texture_option_t& option = mtl.bump_texopt;
    const auto strength = static_cast<float>(option.bump_multiplier);
    if (!std::isfinite(strength)) {
        unread_["map_Bump"].push_back(mtl.name);
        return;
    }
    const TextureImage bumps = store_.copy_of(*image);
    if (holds_normals(bumps)) {
        TextureSlot slot = slot_of(TextureUse::normal, *image, option);
        slot.strength = strength;
        add_slot(slot, out);
        normals_.push_back(mtl.name);
        return;
    }
    const auto [at, is_new] = bumps_.try_emplace({mtl.bump_texname, strength, option.clamp});
    if (is_new)
        at->second = add_image(
            normals_of_heights(bumps, strength, option.clamp ? Wrap::clamp : Wrap::repeat));
    if (at->second) {
        add_slot(slot_of(TextureUse::normal, *at->second, option), out);
        heights_.push_back(mtl.name);
    }
}

void ObjTextureReader::collect_unread(const tinyobj::material_t& mtl)
{
    const std::pair<const char*, const std::string*> kinds[] = {{"disp", &mtl.displacement_texname},
                                                                {"refl", &mtl.reflection_texname},
                                                                {"map_Ps", &mtl.sheen_texname}};
    for (const auto& [key, name] : kinds)
        if (!name->empty())
            unread_[key].push_back(mtl.name);
}

void ObjTextureReader::note_textures() const
{
    SceneAudit& audit = scene_.audit;
    for (const auto& [key, materials] : unread_)
        audit.warnings.push_back("not read yet: " + key + " of materials (" +
                                 list_names(materials) + ")");
    if (!heights_.empty())
        audit.assumed.push_back("map_Bump of materials (" + list_names(heights_) +
                                ") is heights: white is " + short_number(100 * kHeightOfWhite) +
                                " % of the image's width above black, times -bm");
    if (!normals_.empty())
        audit.assumed.push_back("map_Bump of materials (" + list_names(normals_) +
                                ") is a normal map, as its colours are");
}

std::optional<std::uint32_t> ObjTextureReader::image_of(const std::string& name)
{
    if (name.empty())
        return std::nullopt;
    const auto found = images_.find(name);
    if (found != images_.end())
        return found->second;
    return images_[name] = load_image(name);
}

/// Windows' separators and folders of another machine are usual: then the bare name counts.
std::optional<std::uint32_t> ObjTextureReader::load_image(const std::string& name)
{
    std::string path = name;
    std::replace(path.begin(), path.end(), '\\', '/');
    const std::string bare = path.substr(path.find_last_of('/') + 1);
    std::string problem;
    for (const std::string& candidate : {path, bare}) {
        try {
            const std::vector<std::byte> bytes =
                read_file(file_beside(scene_.path, "texture " + quote_name(name), candidate));
            const auto* const first = reinterpret_cast<const unsigned char*>(bytes.data());
            DecodedTexture decoded = store_.decode({first, bytes.size()});
            problem = decoded.problem;
            decoded.image.name = clean_name(bare);
            if (problem.empty())
                return add_image(std::move(decoded.image));
            break;
        } catch (const InputError&) {
            problem = "cannot be read";
        }
    }
    store_.warn(name, problem);
    return std::nullopt;
}

std::optional<std::uint32_t> ObjTextureReader::add_image(TextureImage image)
{
    if (!store_.has_room_for(image, "texture"))
        return std::nullopt;
    return store_.add(std::move(image));
}

} // namespace hipmap
