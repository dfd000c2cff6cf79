#include "common/scene/obj_material.h"

#include "common/file/output_file.h"
#include "common/scene/obj_texture.h"
#include "common/scene/phong_exponent.h"
#include "common/scene/scene_file.h"
#include "common/scene/scene_names.h"

#include <tiny_obj_loader.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>

namespace hipmap {

namespace {

constexpr float kNearlyBlack = 0.02f; ///< Ks below: no reflection is meant
constexpr float kStrongMirror = 0.5f; ///< Ks from here on, with illum 3 or 5: a mirror
constexpr float kGlassIor = 1.5f;     ///< where Ni is left out

Rgb colour(const tinyobj::real_t (&c)[3])
{
    return {static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2])};
}

Rgb clamped(const Rgb& c)
{
    return glm::clamp(c, Rgb(0.0f), Rgb(1.0f));
}

bool is_mirror(const tinyobj::material_t& mtl)
{
    return (mtl.illum == 3 || mtl.illum == 5) && max_channel(colour(mtl.specular)) >= kStrongMirror;
}

/// Exporters write Tf 1 1 1 on opaque things too, so black and white say nothing.
bool is_transparent(const tinyobj::material_t& mtl)
{
    const Rgb filter = clamped(colour(mtl.transmittance));
    return mtl.illum == 4 || mtl.illum == 6 || mtl.illum == 7 || mtl.illum == 9 ||
           mtl.dissolve < 1 || (filter != Rgb(0.0f) && filter != Rgb(1.0f));
}

void make_transparent(const tinyobj::material_t& mtl, Material& out)
{
    const bool partly = mtl.dissolve < 1 && mtl.dissolve > 0;
    const Rgb filter = clamped(colour(mtl.transmittance));
    out.transmission = partly ? static_cast<float>(1 - mtl.dissolve) : 1.0f;
    if (!is_black(filter))
        out.base_color = filter;
    else if (is_black(out.base_color))
        out.base_color = Rgb(1.0f);
    out.ior = mtl.ior > 1 ? static_cast<float>(mtl.ior) : kGlassIor;
    out.specular = 1.0f;
    out.roughness = 0.0f;
}

Material convert(const tinyobj::material_t& mtl)
{
    Material out;
    out.name = clean_name(mtl.name);
    out.base_color = clamped(colour(mtl.diffuse));
    out.emission = glm::max(colour(mtl.emission), Rgb(0.0f));
    out.metallic = 0.0f;
    out.double_sided = true; // OBJ knows no back faces
    const bool physical = mtl.roughness > 0 || mtl.metallic > 0;
    if (physical) {
        out.metallic = std::clamp(static_cast<float>(mtl.metallic), 0.0f, 1.0f);
        out.roughness = std::clamp(static_cast<float>(mtl.roughness), 0.0f, 1.0f);
    } else if (max_channel(colour(mtl.specular)) < kNearlyBlack) {
        out.specular = 0.0f;
    } else {
        out.roughness = roughness_of_exponent(mtl.shininess);
    }
    if (mtl.ior > 1)
        out.ior = static_cast<float>(mtl.ior);
    if (!physical && is_mirror(mtl)) {
        out.metallic = 1.0f;
        out.roughness = 0.0f;
        out.base_color = clamped(colour(mtl.specular));
    } else if (is_transparent(mtl)) {
        make_transparent(mtl, out);
    }
    return out;
}

bool has_unread_factor(const tinyobj::material_t& mtl)
{
    return mtl.sheen > 0 || mtl.clearcoat_thickness > 0 || mtl.anisotropy > 0;
}

/// A light by its name or by an ambient term above 1, but without the Ke that makes it emit.
bool looks_like_dark_light(const tinyobj::material_t& mtl)
{
    if (max_channel(colour(mtl.emission)) > 0)
        return false;
    std::string name = mtl.name;
    for (char& c : name)
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    for (const char* word : {"light", "lamp", "emit", "emissi", "glow", "bulb", "neon"})
        if (name.find(word) != std::string::npos)
            return true;
    return max_channel(colour(mtl.ambient)) > 1;
}

/// The files an mtllib line may mean: the whole line, since names contain spaces, or its words.
std::vector<std::string> possible_names(const std::string& line)
{
    std::vector<std::string> names = {line};
    std::istringstream words(line);
    for (std::string word; words >> word;)
        if (word != line)
            names.push_back(word);
    return names;
}

/// A material, and whether Blender wrote its file.
struct MtlMaterial {
    tinyobj::material_t mtl;
    bool by_blender = false;
};

std::vector<MtlMaterial> parse_mtl(const std::filesystem::path& path)
{
    const std::vector<std::byte> bytes = read_file(path);
    const std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    std::istringstream stream(text);
    std::map<std::string, int> ids;
    std::vector<tinyobj::material_t> materials;
    std::string warning, error;
    tinyobj::LoadMtl(&ids, &materials, &stream, &warning, &error);
    std::vector<MtlMaterial> out;
    for (tinyobj::material_t& mtl : materials)
        out.push_back({std::move(mtl), text.starts_with("# Blender")});
    return out;
}

std::vector<MtlMaterial> load_library(const std::string& line, RawScene& scene)
{
    std::vector<MtlMaterial> materials;
    std::string problem;
    bool found = false;
    for (const std::string& name : possible_names(line)) {
        try {
            for (MtlMaterial& read : parse_mtl(file_beside(scene.path, "mtllib", name)))
                materials.push_back(std::move(read));
            found = true;
        } catch (const InputError& error) {
            problem = problem.empty() ? error.what() : problem;
        }
        if (found && name == line)
            break;
    }
    if (!found)
        scene.audit.warnings.push_back(problem);
    return materials;
}

void note_materials(const std::vector<tinyobj::material_t>& materials, SceneAudit& audit)
{
    std::vector<std::string> unread, dark_lights;
    for (const tinyobj::material_t& mtl : materials) {
        if (has_unread_factor(mtl))
            unread.push_back(mtl.name);
        if (looks_like_dark_light(mtl))
            dark_lights.push_back(mtl.name);
    }
    if (!unread.empty())
        audit.warnings.push_back("not read yet: sheen, clearcoat and anisotropy of materials (" +
                                 list_names(unread) + ")");
    if (!dark_lights.empty())
        audit.warnings.push_back("material " + list_names(dark_lights) +
                                 " looks like a light but has no emission: add a line such as "
                                 "'Ke 20 20 20' in the .mtl file");
}

} // namespace

std::map<std::string, MaterialId> read_obj_materials(const ObjText& text, RawScene& scene)
{
    std::map<std::string, MaterialId> ids;
    std::vector<tinyobj::material_t> all;
    ObjTextureReader textures(scene);
    for (const std::string& line : text.material_libs) {
        for (auto& [mtl, by_blender] : load_library(line, scene)) {
            const auto id = static_cast<MaterialId>(scene.materials.size());
            if (mtl.name.empty() || !ids.emplace(mtl.name, id).second)
                continue; // of equal names the first counts
            scene.materials.push_back(convert(mtl));
            textures.read(mtl, by_blender, scene.materials.back());
            all.push_back(std::move(mtl));
        }
    }
    textures.note_textures();
    note_materials(all, scene.audit);
    return ids;
}

Material obj_default_material()
{
    Material material;
    material.name = "(no material)";
    material.base_color = Rgb(0.8f);
    material.metallic = 0.0f;
    material.specular = 0.0f;
    material.double_sided = true;
    return material;
}

} // namespace hipmap
