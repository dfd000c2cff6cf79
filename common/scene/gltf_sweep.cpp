#include "common/scene/gltf_accessor.h"
#include "common/scene/gltf_animation.h"
#include "common/scene/gltf_deformation.h"
#include "common/scene/gltf_instances.h"
#include "common/scene/gltf_nodes.h"
#include "common/scene/gltf_skin.h"

#include <algorithm>
#include <numeric>

namespace hipmap {

namespace {

using Box = Bounds<glm::dvec3>;

constexpr std::size_t kMostPoses = 256; // the frame need not be exact

std::vector<double> some_key_times(const GltfAnimation& animation)
{
    std::vector<double> times;
    for (const AnimationChannel& channel : animation.channels)
        times.insert(times.end(), channel.times.begin(), channel.times.end());
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    if (times.size() <= kMostPoses)
        return times;
    std::vector<double> some;
    for (std::size_t i = 0; i < kMostPoses; ++i)
        some.push_back(times[i * (times.size() - 1) / (kMostPoses - 1)]);
    return some;
}

/// Adds the corners of a box that is placed by `to_outside`.
void add_box(Box& into, const Box& box, const glm::dmat4& to_outside)
{
    if (box.empty())
        return;
    for (int corner = 0; corner < 8; ++corner) {
        glm::dvec4 p(box.low, 1.0);
        for (int axis = 0; axis < 3; ++axis)
            if ((corner >> axis & 1) != 0)
                p[axis] = box.high[axis];
        into.add(glm::dvec3(to_outside * p));
    }
}

/// The boxes of a node's mesh over all weights of its morph targets from 0 to 1.
struct MeshBoxes {
    Box all;                   ///< with all instances, in the node's space
    std::vector<Box> by_joint; ///< [J] of the vertices that follow each joint; empty: none does
};

/// The boxes of what a vertex reaches, [V].
std::vector<Box> boxes_of_vertices(const GltfAccessor& positions,
                                   const std::vector<MorphTarget>& targets)
{
    std::vector<Box> out(positions.size());
    for (std::size_t v = 0; v < out.size(); ++v)
        out[v].add(positions.vec3(v));
    for (const MorphTarget& target : targets)
        for (const Displacement& moved : target.positions) {
            Box& box = out[moved.vertex];
            box.low += glm::min(glm::dvec3(moved.by), glm::dvec3(0.0));
            box.high += glm::max(glm::dvec3(moved.by), glm::dvec3(0.0));
        }
    return out;
}

void add_followers(const GltfDeformation& deformation, const std::vector<Box>& vertices,
                   std::vector<Box>& by_joint)
{
    const std::size_t each = deformation.joints_per_vertex;
    for (std::size_t i = 0; i < deformation.shares.size(); ++i) {
        const auto [joint, share] = deformation.shares[i];
        if (!(share > 0) || joint >= by_joint.size())
            continue;
        by_joint[joint].add(vertices[i / each].low);
        by_joint[joint].add(vertices[i / each].high);
    }
}

MeshBoxes boxes_of_node(const tinygltf::Model& model, std::size_t node, std::size_t joints,
                        const std::filesystem::path& path)
{
    MeshBoxes out;
    Box mesh;
    bool follows = false;
    out.by_joint.resize(joints);
    for (const tinygltf::Primitive& primitive :
         model.meshes[static_cast<std::size_t>(model.nodes[node].mesh)].primitives) {
        const auto found = primitive.attributes.find("POSITION");
        if (found == primitive.attributes.end())
            continue;
        const GltfAccessor positions(model, found->second, path);
        std::vector<std::uint32_t> all(positions.size());
        std::iota(all.begin(), all.end(), 0);
        const std::string place = "nodes[" + std::to_string(node) + "].mesh";
        const GltfDeformation deformation =
            read_deformation({model, primitive, path, place}, {all.size(), all});
        const std::vector<Box> vertices = boxes_of_vertices(positions, deformation.targets);
        follows = follows || deformation.joints_per_vertex > 0;
        add_followers(deformation, vertices, out.by_joint);
        for (const Box& vertex : vertices) {
            mesh.add(vertex.low);
            mesh.add(vertex.high);
        }
    }
    if (!follows)
        out.by_joint.clear();
    for (const glm::dmat4& instance : place_instances(model, {node, glm::dmat4(1.0)}, path))
        add_box(out.all, mesh, instance);
    return out;
}

/// Follows the boxes of objects, which are the nodes with meshes in their order, through poses.
class Sweeper {
  public:
    Sweeper(const tinygltf::Model& model, const std::filesystem::path& path)
        : model_(model), path_(path), skins_(read_gltf_skins(model, path))
    {
    }

    void add_pose(SceneSweep& sweep)
    {
        std::size_t object = 0;
        const std::vector<PlacedNode> nodes = place_nodes(model_, path_);
        const std::vector<const glm::dmat4*> to_world =
            transforms_by_node(nodes, model_.nodes.size());
        for (const PlacedNode& at : nodes) {
            const tinygltf::Node& node = model_.nodes[at.node];
            if (!at.visible)
                continue;
            if (node.mesh < 0) {
                sweep.others.add(glm::dvec3(at.to_world[3]));
                continue;
            }
            const GltfSkin* const skin =
                node.skin < 0 ? nullptr : &skins_[static_cast<std::size_t>(node.skin)];
            if (object == boxes_.size()) {
                boxes_.push_back(
                    boxes_of_node(model_, at.node, skin ? skin->joints.size() : 0, path_));
                sweep.objects.emplace_back();
            }
            add_object(at, skin ? place_joints(*skin, to_world) : std::vector<glm::dmat4>{},
                       boxes_[object], sweep.objects[object]);
            ++object;
        }
    }

  private:
    static void add_object(const PlacedNode& at, const std::vector<glm::dmat4>& joints,
                           const MeshBoxes& boxes, Box& into)
    {
        if (joints.empty() || boxes.by_joint.empty())
            return add_box(into, boxes.all, at.to_world);
        for (std::size_t j = 0; j < joints.size(); ++j)
            add_box(into, boxes.by_joint[j], joints[j]);
    }

    const tinygltf::Model& model_;
    const std::filesystem::path& path_;
    std::vector<GltfSkin> skins_;
    std::vector<MeshBoxes> boxes_;
};

} // namespace

std::optional<SceneSweep> sweep_nodes(const GltfAnimation& animation, tinygltf::Model& model,
                                      const std::filesystem::path& path)
{
    if (animation.channels.empty())
        return std::nullopt;
    Sweeper sweeper(model, path);
    SceneSweep sweep;
    for (const double time : some_key_times(animation)) {
        pose_nodes(animation, time, model);
        sweeper.add_pose(sweep);
    }
    return sweep;
}

} // namespace hipmap
