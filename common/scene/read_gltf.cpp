#include "common/scene/read_gltf.h"

#include "common/scene/gltf_light_camera.h"
#include "common/scene/gltf_material.h"
#include "common/scene/gltf_mesh.h"
#include "common/scene/gltf_model.h"
#include "common/scene/gltf_nodes.h"
#include "common/scene/gltf_unread.h"
#include "common/scene/scene_names.h"

#include <optional>

namespace hipmap {

namespace {

/// What turns a primitive's vertices into the world's.
struct Placement {
    glm::dmat4 points{1.0};
    glm::dmat3 normals{1.0}; ///< inverse transpose up to a positive factor
    bool mirrored = false;
};

/// The matrix of cofactors: the inverse transpose times the determinant, and defined without one.
glm::dmat3 cofactors(const glm::dmat3& m)
{
    return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

Placement placement_of(const glm::dmat4& to_world)
{
    double largest = 0.0;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            largest = std::max(largest, std::abs(to_world[column][row]));
    // Scaled first, so that the products below neither overflow nor vanish.
    const glm::dmat3 linear = largest > 0 ? glm::dmat3(to_world) / largest : glm::dmat3(0.0);
    Placement placement;
    placement.points = to_world;
    placement.normals = cofactors(linear);
    placement.mirrored = glm::dot(linear[0], placement.normals[0]) < 0;
    if (placement.mirrored)
        placement.normals = -placement.normals;
    return placement;
}

glm::vec3 unit_or_zero(const glm::dvec3& v)
{
    const double length = glm::length(v);
    return length > 0 && std::isfinite(length) ? glm::vec3(v / length) : glm::vec3(0.0f);
}

void append(const GltfPrimitive& primitive, MaterialId material, const Placement& placement,
            RawScene& scene)
{
    const auto first = static_cast<std::uint32_t>(scene.positions.size());
    for (const glm::dvec3& p : primitive.positions)
        scene.positions.emplace_back(placement.points * glm::dvec4(p, 1.0));
    for (const glm::dvec3& n : primitive.normals)
        scene.normals.push_back(unit_or_zero(placement.normals * n));
    scene.normals.resize(scene.positions.size(), glm::vec3(0.0f));
    for (glm::uvec3 face : primitive.corners) {
        if (placement.mirrored)
            std::swap(face.y, face.z);
        scene.corners.push_back(face + first);
    }
    scene.material_of_face.resize(scene.corners.size(), material);
    scene.object_of_face.resize(scene.corners.size(),
                                static_cast<ObjectId>(scene.objects.size() - 1));
}

/// Reads each mesh once and places it at every node that uses it.
class InstancePlacer {
  public:
    InstancePlacer(const tinygltf::Model& model, RawScene& scene)
        : model_(model), scene_(scene), reader_(model, scene), meshes_(model.meshes.size())
    {
    }

    void place(const std::vector<PlacedNode>& nodes)
    {
        std::size_t faces = 0, vertices = 0;
        for (const PlacedNode& at : nodes) {
            const int mesh = model_.nodes[at.node].mesh;
            if (mesh < 0)
                continue;
            for (const GltfPrimitive& primitive : mesh_of(mesh)) {
                faces += primitive.corners.size();
                vertices += primitive.positions.size();
            }
            if (faces >= kNone || vertices >= kNone)
                throw scene_error(scene_.path, "",
                                  "more than 2^32 - 2 faces or vertices; export "
                                  "fewer instances");
        }
        reserve(faces, vertices);
        for (const PlacedNode& at : nodes)
            if (model_.nodes[at.node].mesh >= 0)
                place_mesh(at);
        if (!without_material_.empty())
            scene_.audit.assumed.push_back("no material on " + list_names(without_material_) +
                                           ": white rough metal, as glTF has it; give them a "
                                           "material with a Principled BSDF");
    }

  private:
    const std::vector<GltfPrimitive>& mesh_of(int index)
    {
        std::optional<std::vector<GltfPrimitive>>& mesh = meshes_[static_cast<std::size_t>(index)];
        if (!mesh)
            mesh = reader_.read(static_cast<std::size_t>(index));
        return *mesh;
    }

    void place_mesh(const PlacedNode& at)
    {
        const tinygltf::Node& node = model_.nodes[at.node];
        const std::string mesh_name =
            clean_name(model_.meshes[static_cast<std::size_t>(node.mesh)].name);
        std::string name = clean_name(node.name);
        if (name.empty())
            name = mesh_name.empty() ? "object " + std::to_string(at.node) : mesh_name;
        scene_.objects.push_back({name, mesh_name});
        const Placement placement = placement_of(at.to_world);
        for (const GltfPrimitive& primitive : mesh_of(node.mesh)) {
            const bool bare = primitive.material < 0;
            if (bare)
                without_material_.push_back(name);
            append(primitive,
                   bare ? default_material() : static_cast<MaterialId>(primitive.material),
                   placement, scene_);
        }
    }

    MaterialId default_material()
    {
        if (default_material_ == kNone) {
            default_material_ = static_cast<MaterialId>(scene_.materials.size());
            scene_.materials.push_back(gltf_default_material());
        }
        return default_material_;
    }

    void reserve(std::size_t faces, std::size_t vertices)
    {
        scene_.positions.reserve(vertices);
        scene_.normals.reserve(vertices);
        scene_.corners.reserve(faces);
        scene_.material_of_face.reserve(faces);
        scene_.object_of_face.reserve(faces);
    }

    const tinygltf::Model& model_;
    RawScene& scene_;
    GltfMeshReader reader_;
    std::vector<std::optional<std::vector<GltfPrimitive>>> meshes_;
    std::vector<std::string> without_material_;
    MaterialId default_material_ = kNone;
};

std::string first_name(std::initializer_list<std::string> names)
{
    for (const std::string& name : names)
        if (!name.empty())
            return clean_name(name);
    return {};
}

void add_lights_and_cameras(const tinygltf::Model& model, const std::vector<PlacedNode>& nodes,
                            RawScene& scene)
{
    for (const PlacedNode& at : nodes) {
        const tinygltf::Node& node = model.nodes[at.node];
        if (node.camera >= 0) {
            const auto camera = static_cast<std::size_t>(node.camera);
            const std::string name = first_name(
                {node.name, model.cameras[camera].name, "camera " + std::to_string(camera)});
            add_gltf_camera(model, camera, name, at.to_world, scene);
        }
        const auto punctual = node.extensions.find("KHR_lights_punctual");
        if (punctual != node.extensions.end()) {
            const auto light =
                static_cast<std::size_t>(punctual->second.Get("light").GetNumberAsInt());
            const std::string name =
                first_name({node.name, model.lights[light].name, "light " + std::to_string(light)});
            add_gltf_light(model, light, name, at.to_world, scene);
        }
    }
}

void note_scenes(const tinygltf::Model& model, SceneAudit& audit)
{
    if (model.scenes.size() < 2)
        return;
    const auto scene = static_cast<std::size_t>(std::max(0, model.defaultScene));
    audit.assumed.push_back(
        "of " + std::to_string(model.scenes.size()) +
        " scenes in the file the active one is taken: " +
        quote_name(first_name({model.scenes[scene].name, "scene " + std::to_string(scene)})));
}

} // namespace

RawScene read_gltf(const std::filesystem::path& path)
{
    const GltfDocument document = read_gltf_document(path);
    const tinygltf::Model model = parse_gltf(document);
    RawScene scene;
    scene.path = path;
    read_gltf_materials(document, scene);
    const std::vector<PlacedNode> nodes = place_nodes(model, path);
    InstancePlacer(model, scene).place(nodes);
    add_lights_and_cameras(model, nodes, scene);
    note_scenes(model, scene.audit);
    warn_of_unread_gltf(document, scene.audit);
    return scene;
}

} // namespace hipmap
