#include "common/scene/gltf_placement.h"

#include "common/scene/gltf_instances.h"
#include "common/scene/gltf_material.h"
#include "common/scene/gltf_mesh.h"
#include "common/scene/gltf_pose.h"
#include "common/scene/gltf_sharing.h"
#include "common/scene/gltf_skin.h"
#include "common/scene/placement.h"
#include "common/scene/scene_names.h"

#include <tbb/parallel_for.h>
#include <unistd.h>

#include <optional>
#include <utility>

namespace hipmap {

namespace {

/// What loading takes at its peak, where a scene's doubles and floats are held side by side.
constexpr double kBytesPerFace = 20;
constexpr double kBytesPerVertex = 48;
constexpr double kBytesPerInstance = 128;

double physical_memory()
{
    return static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
           static_cast<double>(sysconf(_SC_PAGESIZE));
}

/// Appends `some` to `all`, of which [count] are there: either may be empty while the other is not.
template <typename T>
void append_or_fill(std::vector<T>& all, std::size_t count, const std::vector<T>& some, T filler)
{
    if (some.empty() && all.empty())
        return;
    all.resize(count, filler);
    all.insert(all.end(), some.begin(), some.end());
}

/// Appends to the attributes of [count] vertices; afterwards each array may be shorter than the
/// positions, where what was last added lacks it.
void append_attributes(const VertexAttributes& some, std::size_t count, const Placement& placement,
                       VertexAttributes& all)
{
    for (std::size_t set = 0; set < all.uv.size(); ++set)
        append_or_fill(all.uv[set], count, some.uv[set], glm::vec2(0.0f));
    append_or_fill(all.colours, count, some.colours, glm::vec4(1.0f));
    append_or_fill(all.tangents, count, some.tangents, glm::vec4(0.0f));
    for (std::size_t i = count; i < all.tangents.size(); ++i)
        all.tangents[i] = place_tangent(all.tangents[i], placement);
}

/// Appends make(element) for each of `some`, in parallel.
template <typename From, typename To, typename Make>
void append_each(const std::vector<From>& some, std::vector<To>& all, const Make& make)
{
    const std::size_t first = all.size();
    all.resize(first + some.size());
    tbb::parallel_for(std::size_t{0}, some.size(),
                      [&](std::size_t i) { all[first + i] = make(some[i]); });
}

void append(const GltfPrimitive& primitive, MaterialId material, const Placement& placement,
            RawScene& scene)
{
    const auto first = static_cast<std::uint32_t>(scene.positions.size());
    append_attributes(primitive.attributes, first, placement, scene.attributes);
    append_each(primitive.positions, scene.positions, [&](const glm::dvec3& p) {
        return glm::dvec3(placement.points * glm::dvec4(p, 1.0));
    });
    append_each(primitive.normals, scene.normals,
                [&](const glm::dvec3& n) { return unit_or_zero(placement.normals * n); });
    scene.normals.resize(scene.positions.size(), glm::vec3(0.0f));
    append_each(primitive.corners, scene.corners, [&](const glm::uvec3& face) {
        return first + (placement.mirrored ? glm::uvec3(face.x, face.z, face.y) : face);
    });
    scene.material_of_face.resize(scene.corners.size(), material);
    scene.object_of_face.resize(scene.corners.size(),
                                static_cast<ObjectId>(scene.objects.size() - 1));
}

/// Reads each mesh once and places it at every node that uses it.
class MeshPlacer {
  public:
    MeshPlacer(const tinygltf::Model& model, const WantedAttributes& wanted,
               std::uint64_t least_copied, RawScene& scene)
        : model_(model), scene_(scene), skins_(read_gltf_skins(model, scene.path)),
          reader_(model, wanted, scene), meshes_(model.meshes.size()), sharing_(model, scene),
          least_copied_(least_copied)
    {
    }

    void place(const std::vector<PlacedNode>& nodes)
    {
        to_world_ = transforms_by_node(nodes, model_.nodes.size());
        if (least_copied_ != kNever)
            allow_copies(nodes);
        reserve(nodes);
        for (const PlacedNode& at : nodes)
            if (at.visible && model_.nodes[at.node].mesh >= 0)
                place_mesh(at);
        append_attributes({}, scene_.positions.size(), {}, scene_.attributes);
        drop_unshared(scene_.shared, scene_.copies);
        if (!skinned_.empty())
            scene_.audit.found.push_back("armature (skin) of " + list_names(skinned_));
        if (!shaped_.empty())
            scene_.audit.found.push_back("shape keys (morph targets) of " + list_names(shaped_));
        if (!without_material_.empty())
            scene_.audit.assumed.push_back(
                "no material on " + list_names(without_material_) + ": using " +
                (is_blender(scene_.look) ? "matte grey 0.8, as Cycles does"
                                         : "white rough metal, glTF's default") +
                "; give them a material with a Principled BSDF");
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
        for (const GltfPrimitive& primitive : mesh_of(node.mesh))
            if (primitive.material < 0)
                without_material_.push_back(name);
        const std::vector<glm::dmat4> joints = joints_of(node, name);
        const MeshPose pose{morph_weights(model_, node), joints};
        const bool shared = sharing_.is_allowed(node);
        for (const glm::dmat4& to_world : place_instances(model_, at, scene_.path))
            if (!shared || !sharing_.add_copy(node.mesh, to_world, scene_))
                place_instance(node, pose, to_world);
    }

    void place_instance(const tinygltf::Node& node, const MeshPose& pose,
                        const glm::dmat4& to_world)
    {
        const auto face = static_cast<FaceId>(scene_.corners.size());
        const auto vertex = static_cast<std::uint32_t>(scene_.positions.size());
        const Placement placement = placement_of(to_world);
        for (const GltfPrimitive& primitive : mesh_of(node.mesh))
            append_posed(primitive, pose, placement);
        if (sharing_.is_allowed(node))
            sharing_.add_stored(node.mesh, to_world,
                                {face, static_cast<FaceId>(scene_.corners.size()) - face, vertex,
                                 static_cast<std::uint32_t>(scene_.positions.size()) - vertex},
                                scene_);
    }

    /// Allows copies of meshes whose instances would add enough faces.
    void allow_copies(const std::vector<PlacedNode>& nodes)
    {
        std::vector<std::uint64_t> instances(meshes_.size(), 0);
        for (const PlacedNode& at : nodes)
            if (at.visible && sharing_.may_share(model_.nodes[at.node]))
                instances[static_cast<std::size_t>(model_.nodes[at.node].mesh)] +=
                    count_instances(model_, at.node, scene_.path);
        for (std::size_t mesh = 0; mesh < instances.size(); ++mesh) {
            if (instances[mesh] < 2)
                continue;
            std::uint64_t faces = 0;
            for (const GltfPrimitive& primitive : mesh_of(static_cast<int>(mesh)))
                faces += primitive.corners.size();
            if (instances[mesh] < kNone && (instances[mesh] - 1) * faces >= least_copied_)
                sharing_.allow(static_cast<int>(mesh));
        }
    }

    /// The transforms of the joints of a node's skin; none if it has none.
    std::vector<glm::dmat4> joints_of(const tinygltf::Node& node, const std::string& name)
    {
        if (node.skin < 0)
            return {};
        const GltfSkin& skin = skins_[static_cast<std::size_t>(node.skin)];
        std::vector<glm::dmat4> joints = place_joints(skin, to_world_);
        if (joints.empty())
            scene_.audit.warnings.push_back("skin of " + quote_name(name) +
                                            " is ignored: the scene lacks some of its joints");
        for (const GltfPrimitive& primitive : mesh_of(node.mesh))
            for (const JointShare& share : primitive.deformation.shares)
                if (share.joint >= skin.joints.size())
                    throw scene_error(scene_.path, "object " + quote_name(name),
                                      "follows joint " + std::to_string(share.joint) + " of " +
                                          std::to_string(skin.joints.size()) +
                                          "; the file is damaged, export it again");
        return joints;
    }

    /// A mesh that follows joints is placed by them alone (glTF 2.0, section 3.7.3.3).
    void append_posed(const GltfPrimitive& primitive, const MeshPose& pose,
                      const Placement& placement)
    {
        const MaterialId material = primitive.material < 0
                                        ? default_material()
                                        : static_cast<MaterialId>(primitive.material);
        if (!deforms(pose, primitive))
            return append(primitive, material, placement, scene_);
        const bool follows = follows_joints(pose, primitive);
        append(posed(primitive, pose), material, follows ? Placement{} : placement, scene_);
        (follows ? skinned_ : shaped_).push_back(scene_.objects.back().name);
    }

    MaterialId default_material()
    {
        if (default_material_ == kNone) {
            default_material_ = static_cast<MaterialId>(scene_.materials.size());
            scene_.materials.push_back(gltf_default_material(scene_.look));
        }
        return default_material_;
    }

    /// Faces, vertices and instances of a scene.
    struct Amount {
        std::uint64_t faces = 0, vertices = 0; ///< stored
        std::uint64_t instances = 0;
        std::uint64_t all_faces = 0; ///< with copies
    };

    /// Makes room for all, once it is known to fit.
    void reserve(const std::vector<PlacedNode>& nodes)
    {
        Amount all;
        std::vector<std::uint8_t> stored(meshes_.size(), 0);
        for (const PlacedNode& at : nodes) {
            const tinygltf::Node& node = model_.nodes[at.node];
            if (node.mesh < 0 || !at.visible)
                continue;
            const std::uint64_t instances = count_instances(model_, at.node, scene_.path);
            all.instances += instances;
            check_amount(all);
            // Of copies one is stored, as far as is known now.
            const bool is_first =
                std::exchange(stored[static_cast<std::size_t>(node.mesh)], 1) == 0;
            const std::uint64_t times = sharing_.is_allowed(node) ? is_first : instances;
            for (const GltfPrimitive& primitive : mesh_of(node.mesh)) {
                // Factors below 2^32, so nothing wraps.
                all.faces += times * primitive.corners.size();
                all.vertices += times * primitive.positions.size();
                all.all_faces += instances * primitive.corners.size();
                check_amount(all);
            }
        }
        scene_.positions.reserve(all.vertices);
        scene_.normals.reserve(all.vertices);
        scene_.corners.reserve(all.faces);
        scene_.material_of_face.reserve(all.faces);
        scene_.object_of_face.reserve(all.faces);
    }

    void check_amount(const Amount& all) const
    {
        if (all.instances >= kNone || all.all_faces >= kNone || all.vertices >= kNone)
            throw scene_error(scene_.path, "",
                              "more than 2^32 - 2 faces or vertices; export fewer instances");
        const double bytes = static_cast<double>(all.faces) * kBytesPerFace +
                             static_cast<double>(all.vertices) * kBytesPerVertex +
                             static_cast<double>(all.instances) * kBytesPerInstance;
        if (bytes > physical_memory())
            throw scene_error(scene_.path, "",
                              "its faces and instances need " + short_number(bytes / 1e9) +
                                  " GB of memory, more than is available; export fewer");
    }

    const tinygltf::Model& model_;
    RawScene& scene_;
    std::vector<GltfSkin> skins_;
    std::vector<const glm::dmat4*> to_world_; ///< by node, borrowed while placing
    GltfMeshReader reader_;
    std::vector<std::optional<std::vector<GltfPrimitive>>> meshes_;
    GltfSharing sharing_;
    std::uint64_t least_copied_;                                   ///< faces
    std::vector<std::string> without_material_, skinned_, shaped_; ///< names of objects
    MaterialId default_material_ = kNone;
};

} // namespace

void place_meshes(const tinygltf::Model& model, const std::vector<PlacedNode>& nodes,
                  const WantedAttributes& wanted, std::uint64_t least_copied, RawScene& scene)
{
    MeshPlacer(model, wanted, least_copied, scene).place(nodes);
}

} // namespace hipmap
