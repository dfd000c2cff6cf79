#include "common/scene/gltf_nodes.h"

#include "common/scene/raw_scene.h"

#include <glm/gtc/type_ptr.hpp>

#include <cmath>

namespace hipmap {

namespace {

std::string place_of(std::size_t node)
{
    return "nodes[" + std::to_string(node) + "]";
}

bool is_affine(const glm::dmat4& m)
{
    return m[0][3] == 0 && m[1][3] == 0 && m[2][3] == 0 && m[3][3] == 1;
}

glm::dmat4 rotation_matrix(const glm::dvec4& q)
{
    const double length = glm::length(q);
    if (!(length > 0) || !std::isfinite(length))
        return glm::dmat4(1.0); // no rotation can be meant by a quaternion of zeros
    const double x = q.x / length, y = q.y / length, z = q.z / length, w = q.w / length;
    glm::dmat4 m(1.0);
    m[0] = {1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w), 0};
    m[1] = {2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w), 0};
    m[2] = {2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y), 0};
    return m;
}

glm::dmat4 local_transform(const tinygltf::Node& node)
{
    if (node.matrix.size() == 16)
        return glm::make_mat4(node.matrix.data());
    NodeTransform parts;
    if (node.rotation.size() == 4)
        parts.rotation = glm::make_vec4(node.rotation.data());
    if (node.scale.size() == 3)
        parts.scale = glm::make_vec3(node.scale.data());
    if (node.translation.size() == 3)
        parts.translation = glm::make_vec3(node.translation.data());
    return to_matrix(parts);
}

bool is_hidden(const tinygltf::Node& node)
{
    const auto found = node.extensions.find("KHR_node_visibility");
    return found != node.extensions.end() && found->second.Has("visible") &&
           found->second.Get("visible").IsBool() && !found->second.Get("visible").Get<bool>();
}

/// How many nodes have each node as a child.
std::vector<int> count_parents(const tinygltf::Model& model, const std::filesystem::path& path)
{
    std::vector<int> parents(model.nodes.size(), 0);
    for (const tinygltf::Node& node : model.nodes)
        for (const int child : node.children)
            if (++parents[static_cast<std::size_t>(child)] > 1)
                throw scene_error(path, place_of(static_cast<std::size_t>(child)),
                                  "has two parents; the file is damaged, export it again");
    return parents;
}

std::vector<std::size_t> root_nodes(const tinygltf::Model& model, const std::vector<int>& parents)
{
    std::vector<std::size_t> roots;
    if (model.scenes.empty()) {
        for (std::size_t node = 0; node < parents.size(); ++node)
            if (parents[node] == 0)
                roots.push_back(node);
        return roots;
    }
    const auto scene = static_cast<std::size_t>(std::max(0, model.defaultScene));
    for (const int node : model.scenes[scene].nodes)
        roots.push_back(static_cast<std::size_t>(node));
    return roots;
}

} // namespace

glm::dmat4 to_matrix(const NodeTransform& transform)
{
    glm::dmat4 m = rotation_matrix(transform.rotation);
    for (int axis = 0; axis < 3; ++axis)
        m[axis] *= transform.scale[axis];
    m[3] = glm::dvec4(transform.translation, 1.0);
    return m;
}

bool is_finite_transform(const glm::dmat4& m)
{
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!std::isfinite(m[column][row]))
                return false;
    return true;
}

std::vector<PlacedNode> place_nodes(const tinygltf::Model& model, const std::filesystem::path& path)
{
    const std::vector<int> parents = count_parents(model, path);
    const std::vector<std::size_t> roots = root_nodes(model, parents);
    std::vector<PlacedNode> placed, waiting;
    for (auto root = roots.rbegin(); root != roots.rend(); ++root)
        waiting.push_back({*root, glm::dmat4(1.0)});

    // Without two parents only a loop can come back to a node, and a loop has no way in but
    // through a root that is also a child.
    std::vector<bool> seen(model.nodes.size(), false);
    while (!waiting.empty()) {
        PlacedNode at = waiting.back();
        waiting.pop_back();
        if (seen[at.node])
            throw scene_error(path, place_of(at.node),
                              "is its own ancestor or listed twice; the file is damaged, export "
                              "it again");
        seen[at.node] = true;
        const tinygltf::Node& node = model.nodes[at.node];
        const glm::dmat4 local = local_transform(node);
        at.to_world = at.to_world * local;
        if (!is_affine(local) || !is_finite_transform(at.to_world))
            throw scene_error(path, place_of(at.node),
                              "its transform is not finite or not affine; apply the transform and "
                              "export again");
        at.visible = at.visible && !is_hidden(node);
        placed.push_back(at);
        for (auto child = node.children.rbegin(); child != node.children.rend(); ++child)
            waiting.push_back({static_cast<std::size_t>(*child), at.to_world, at.visible});
    }
    if (model.scenes.empty() && placed.size() < model.nodes.size())
        throw scene_error(path, "nodes", "contain a loop; the file is damaged, export it again");
    return placed;
}

} // namespace hipmap
