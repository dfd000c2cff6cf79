#include "common/scene/read_obj.h"

#include "common/scene/obj_material.h"
#include "common/scene/obj_text.h"
#include "common/scene/scene_names.h"
#include "common/scene/triangulate.h"

#include <tiny_obj_loader.h>

#include <map>
#include <sstream>
#include <unordered_map>

namespace hipmap {

namespace {

/// Cutting ears off a polygon takes quadratic time and more.
constexpr std::size_t kMostCorners = 10000;

/// What makes a vertex: numbers in the file's lists of positions, normals and texture coordinates.
struct ObjCorner {
    std::size_t position, normal, texcoord;

    bool operator==(const ObjCorner&) const = default;
};

struct HashOfCorner {
    std::size_t operator()(const ObjCorner& corner) const
    {
        constexpr std::size_t kOdd = 0x9e3779b97f4a7c15; // spreads sums over all bits
        return ((corner.position * kOdd ^ corner.normal) * kOdd ^ corner.texcoord) * kOdd;
    }
};

/// Builds the scene from tinyobjloader's callbacks; every index was checked by read_obj_text.
class ObjBuilder {
  public:
    ObjBuilder(const ObjText& text, RawScene& scene)
        : scene_(scene), groups_are_objects_(!text.has_objects),
          materials_(read_obj_materials(text, scene)), textured_(!scene.images.empty())
    {
    }

    void add_vertex(const glm::dvec3& p) { vertices_.push_back(p); }
    void add_normal(const glm::dvec3& n) { normals_.push_back(n); }
    /// v upwards, as the file has it.
    void add_texcoord(const glm::dvec2& uv)
    {
        texcoords_.emplace_back(static_cast<float>(uv.x), static_cast<float>(1 - uv.y));
    }

    void name_object(const std::string& name) { object_name_ = clean_name(name); }
    void name_group(const std::string& name)
    {
        if (groups_are_objects_)
            name_object(name);
    }

    void use_material(std::string name)
    {
        name.erase(name.find_last_not_of(" \t") + 1);
        const auto found = materials_.find(name);
        material_ = found == materials_.end() ? kNone : found->second;
        if (found == materials_.end())
            unknown_.push_back(name);
    }

    void add_face(std::span<const tinyobj::index_t> face)
    {
        if (face.size() < 3)
            return;
        if (face.size() > kMostCorners)
            throw scene_error(scene_.path,
                              "face after " + counted(scene_.corners.size(), "triangle"),
                              "has more than 10,000 corners; triangulate when exporting");
        std::vector<glm::dvec3> points;
        std::vector<std::uint32_t> corners;
        for (const tinyobj::index_t& index : face) {
            corners.push_back(corner(index));
            points.push_back(scene_.positions[corners.back()]);
        }
        for (const glm::uvec3& t : triangulate(points)) {
            scene_.corners.emplace_back(corners[t.x], corners[t.y], corners[t.z]);
            scene_.material_of_face.push_back(material());
            scene_.object_of_face.push_back(object());
        }
        if (scene_.corners.size() >= kNone)
            throw scene_error(scene_.path, "", "more than 2^32 - 2 faces; export fewer");
    }

    void finish()
    {
        if (!unknown_.empty())
            scene_.audit.warnings.push_back("materials missing in the .mtl files: " +
                                            list_names(unknown_) + "; using grey 0.8");
        else if (default_material_ != kNone)
            scene_.audit.assumed.push_back("faces without material: using grey 0.8");
    }

  private:
    static std::size_t resolve(int index, std::size_t count)
    {
        return index > 0 ? static_cast<std::size_t>(index) - 1
                         : count - static_cast<std::size_t>(-static_cast<std::int64_t>(index));
    }

    /// The vertex with this position, normal and, if there are textures, place in these; OBJ counts
    /// them apart.
    std::uint32_t corner(const tinyobj::index_t& index)
    {
        const std::size_t position = resolve(index.vertex_index, vertices_.size());
        const std::size_t normal =
            index.normal_index == 0 ? kNone : resolve(index.normal_index, normals_.size());
        const std::size_t texcoord = index.texcoord_index == 0 || !textured_
                                         ? kNone
                                         : resolve(index.texcoord_index, texcoords_.size());
        const auto [at, added] = corner_of_.try_emplace(
            {position, normal, texcoord}, static_cast<std::uint32_t>(scene_.positions.size()));
        if (added) {
            scene_.positions.push_back(vertices_[position]);
            scene_.normals.push_back(normal == kNone ? glm::vec3(0.0f) : unit(normals_[normal]));
            if (textured_)
                scene_.attributes.uv[0].push_back(texcoord == kNone ? glm::vec2(0.0f)
                                                                    : texcoords_[texcoord]);
        }
        return at->second;
    }

    static glm::vec3 unit(const glm::dvec3& n)
    {
        const double length = glm::length(n);
        return length > 0 && std::isfinite(length) ? glm::vec3(n / length) : glm::vec3(0.0f);
    }

    MaterialId material()
    {
        if (material_ != kNone)
            return material_;
        if (default_material_ == kNone) {
            default_material_ = static_cast<MaterialId>(scene_.materials.size());
            scene_.materials.push_back(obj_default_material());
        }
        return default_material_;
    }

    ObjectId object()
    {
        const auto [at, added] =
            object_of_.try_emplace(object_name_, static_cast<ObjectId>(scene_.objects.size()));
        if (added)
            scene_.objects.push_back(
                {object_name_.empty() ? clean_name(scene_.path.stem().string()) : object_name_,
                 ""});
        return at->second;
    }

    RawScene& scene_;
    bool groups_are_objects_;
    std::map<std::string, MaterialId> materials_;
    bool textured_;
    std::vector<glm::dvec3> vertices_, normals_; ///< as the file lists them
    std::vector<glm::vec2> texcoords_;           ///< v downwards
    std::unordered_map<ObjCorner, std::uint32_t, HashOfCorner> corner_of_;
    std::map<std::string, ObjectId> object_of_;
    std::string object_name_;
    MaterialId material_ = kNone;
    MaterialId default_material_ = kNone;
    std::vector<std::string> unknown_;
};

ObjBuilder& builder(void* user)
{
    return *static_cast<ObjBuilder*>(user);
}

tinyobj::callback_t callbacks()
{
    tinyobj::callback_t out;
    out.vertex_cb = [](void* user, double x, double y, double z, double) {
        builder(user).add_vertex({x, y, z});
    };
    out.normal_cb = [](void* user, double x, double y, double z) {
        builder(user).add_normal({x, y, z});
    };
    out.texcoord_cb = [](void* user, double x, double y, double) {
        builder(user).add_texcoord({x, y});
    };
    out.index_cb = [](void* user, tinyobj::index_t* indices, int count) {
        builder(user).add_face({indices, static_cast<std::size_t>(count)});
    };
    out.usemtl_cb = [](void* user, const char* name, int) { builder(user).use_material(name); };
    out.object_cb = [](void* user, const char* name) { builder(user).name_object(name); };
    out.group_cb = [](void* user, const char** names, int count) {
        std::string joined;
        for (int i = 0; i < count; ++i)
            joined.append(i > 0 ? " " : "").append(names[i]);
        builder(user).name_group(joined);
    };
    return out;
}

void note_unread(const ObjText& text, SceneAudit& audit)
{
    if (text.short_faces > 0)
        audit.warnings.push_back(counted(text.short_faces, "face") +
                                 " with fewer than three corners skipped");
    if (text.has_colours)
        audit.warnings.push_back("not read yet: vertex colours");
    if (text.has_lines_or_points)
        audit.warnings.push_back("not read yet: points and lines");
    if (text.has_curves)
        audit.warnings.push_back("not read: curves and surfaces; export them as meshes");
}

} // namespace

RawScene read_obj(const std::filesystem::path& path, double texture_cache_mib)
{
    ObjText text = read_obj_text(path);
    RawScene scene;
    scene.path = path;
    scene.texture_cache_mib = texture_cache_mib;
    ObjBuilder build(text, scene);
    std::istringstream stream(std::move(text.text));
    tinyobj::LoadObjWithCallback(stream, callbacks(), &build);
    build.finish();
    note_unread(text, scene.audit);
    return scene;
}

} // namespace hipmap
