#include "common/scene/gltf_accessor.h"
#include "common/scene/gltf_animation.h"
#include "common/scene/gltf_instances.h"
#include "common/scene/gltf_nodes.h"

#include <algorithm>

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

/// The box of a node's mesh with all its instances, in the node's space.
Box box_of_node(const tinygltf::Model& model, std::size_t node, const std::filesystem::path& path)
{
    Box mesh, out;
    for (const tinygltf::Primitive& primitive :
         model.meshes[static_cast<std::size_t>(model.nodes[node].mesh)].primitives) {
        const auto found = primitive.attributes.find("POSITION");
        if (found == primitive.attributes.end())
            continue;
        const GltfAccessor positions(model, found->second, path);
        for (std::size_t i = 0; i < positions.size(); ++i)
            mesh.add(positions.vec3(i));
    }
    for (const glm::dmat4& instance : place_instances(model, {node, glm::dmat4(1.0)}, path))
        add_box(out, mesh, instance);
    return out;
}

} // namespace

std::optional<SceneSweep> sweep_nodes(const GltfAnimation& animation, tinygltf::Model& model,
                                      const std::filesystem::path& path)
{
    if (animation.channels.empty())
        return std::nullopt;
    std::vector<Box> boxes; // of objects, which are the nodes with meshes in their order
    SceneSweep sweep;
    for (const double time : some_key_times(animation)) {
        pose_nodes(animation, time, model);
        std::size_t object = 0;
        for (const PlacedNode& at : place_nodes(model, path)) {
            if (model.nodes[at.node].mesh < 0) {
                sweep.others.add(glm::dvec3(at.to_world[3]));
                continue;
            }
            if (object == boxes.size()) {
                boxes.push_back(box_of_node(model, at.node, path));
                sweep.objects.emplace_back();
            }
            add_box(sweep.objects[object], boxes[object], at.to_world);
            ++object;
        }
    }
    return sweep;
}

} // namespace hipmap
