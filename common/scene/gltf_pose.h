#pragma once

#include "common/scene/gltf_mesh.h"

#include <span>

namespace hipmap {

/// How a node deforms its mesh.
struct MeshPose {
    std::span<const double> weights;    ///< of morph targets; those that are missing are zero
    std::span<const glm::dmat4> joints; ///< [J] from the mesh's space to the world; empty: no skin
};

/// Returns whether the pose changes the primitive.
bool deforms(const MeshPose& pose, const GltfPrimitive& primitive);

/// Returns whether vertices of the primitive follow joints of the pose, which places them in the
/// world.
bool follows_joints(const MeshPose& pose, const GltfPrimitive& primitive);

/// Returns the primitive as posed: displaced by its morph targets, then moved by its joints (glTF
/// 2.0, sections 3.7.2.2 and 3.7.3.3); in the world if it follows joints, else in the mesh's space.
/// Every joint that the primitive names must be in the pose.
GltfPrimitive posed(const GltfPrimitive& rest, const MeshPose& pose);

} // namespace hipmap
