#include "common/scene/gltf_pose.h"

#include "common/scene/placement.h"

#include <algorithm>

namespace hipmap {

namespace {

template <typename Vector>
void displace(const std::vector<Displacement>& by, double weight, std::vector<Vector>& vectors)
{
    if (vectors.empty()) // the primitive lacks what the target displaces
        return;
    for (const Displacement& one : by)
        for (int axis = 0; axis < 3; ++axis)
            vectors[one.vertex][axis] += static_cast<typename Vector::value_type>(
                weight * static_cast<double>(one.by[axis]));
}

/// The weighted mean of the transforms of a vertex's joints.
glm::dmat4 blended(std::span<const JointShare> shares, std::span<const glm::dmat4> joints)
{
    glm::dmat4 out(0.0);
    for (const JointShare& share : shares)
        if (share.share > 0)
            out += joints[share.joint] * double{share.share};
    return out;
}

void move_by_joints(const MeshPose& pose, GltfPrimitive& primitive)
{
    const std::size_t each = primitive.deformation.joints_per_vertex;
    const std::span<const JointShare> all(primitive.deformation.shares);
    for (std::size_t v = 0; v < primitive.positions.size(); ++v) {
        const Placement placement = placement_of(blended(all.subspan(v * each, each), pose.joints));
        primitive.positions[v] = placement.points * glm::dvec4(primitive.positions[v], 1.0);
        if (!primitive.normals.empty())
            primitive.normals[v] = placement.normals * primitive.normals[v];
        if (!primitive.attributes.tangents.empty())
            primitive.attributes.tangents[v] =
                place_tangent(primitive.attributes.tangents[v], placement);
    }
}

/// Mirrored joints turn the winding of faces.
void keep_fronts(const MeshPose& pose, GltfPrimitive& primitive)
{
    if (!placement_of(pose.joints[0]).mirrored)
        return;
    for (glm::uvec3& face : primitive.corners)
        std::swap(face.y, face.z);
}

} // namespace

bool follows_joints(const MeshPose& pose, const GltfPrimitive& primitive)
{
    return !pose.joints.empty() && primitive.deformation.joints_per_vertex > 0;
}

bool deforms(const MeshPose& pose, const GltfPrimitive& primitive)
{
    return follows_joints(pose, primitive) ||
           (!primitive.deformation.targets.empty() &&
            std::any_of(pose.weights.begin(), pose.weights.end(),
                        [](double weight) { return weight != 0; }));
}

GltfPrimitive posed(const GltfPrimitive& rest, const MeshPose& pose)
{
    GltfPrimitive out = rest;
    const std::vector<MorphTarget>& targets = rest.deformation.targets;
    for (std::size_t i = 0; i < std::min(targets.size(), pose.weights.size()); ++i) {
        const double weight = pose.weights[i];
        if (weight == 0)
            continue;
        displace(targets[i].positions, weight, out.positions);
        displace(targets[i].normals, weight, out.normals);
        displace(targets[i].tangents, weight, out.attributes.tangents);
    }
    if (follows_joints(pose, rest)) {
        move_by_joints(pose, out);
        keep_fronts(pose, out);
    }
    return out;
}

} // namespace hipmap
