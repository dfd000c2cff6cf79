#pragma once

#include "common/scene/gltf_document.h"
#include "common/scene/raw_scene.h"

#include <tiny_gltf.h>

#include <optional>
#include <vector>

namespace hipmap {

enum class NodePart : std::uint8_t { translation, rotation, scale, weight };
enum class Interpolation : std::uint8_t { linear, step, cubic };

/// The animation of one part of a node's transform, or of the weight of one morph target.
struct AnimationChannel {
    std::size_t node = 0;
    NodePart part = NodePart::translation;
    std::size_t target = 0; ///< of weights: the morph target
    Interpolation interpolation = Interpolation::linear;
    std::vector<double> times; ///< [K] s, never falling, at least one
    /// [K], or of cubic [3 K]: tangent in, value, tangent out; w: of rotations alone; x: of
    /// weights.
    std::vector<glm::dvec4> values;
};

/// All animations of a file, played together.
struct GltfAnimation {
    std::vector<AnimationChannel> channels; ///< one at most of each part of a node
    std::vector<std::string> names;         ///< of the animations
    std::vector<std::string> moved;         ///< names of the nodes
    double first = 0.0, last = 0.0;         ///< of all times
};

/// Reads the animations of nodes' transforms and of morph targets, and warns of other animations.
/// If several drive the same part of a node, the first in the file counts.  Throws InputError,
/// naming the place: a sampler or accessor that is missing or of another shape, times that fall,
/// numbers that are not finite, a node that has a matrix.
GltfAnimation read_gltf_animation(const GltfDocument& document, const tinygltf::Model& model,
                                  SceneAudit& audit);

/// Interpolates a channel at `time`, in seconds; before the first key and after the last key it is
/// constant.  Rotations are quaternions x, y, z, w and interpolate along the shorter arc (glTF 2.0,
/// appendix C).
glm::dvec4 value_at(const AnimationChannel& channel, double time);

/// Sets the transforms and weights of the animated nodes to those of `time`.
void pose_nodes(const GltfAnimation& animation, double time, tinygltf::Model& model);

/// Returns the bounds of each object's faces, the lights and the cameras over the animation, from
/// the poses at its keys (at most 256); none if nothing moves.  Throws as place_nodes does.  Leaves
/// the model in an arbitrary pose.
std::optional<SceneSweep> sweep_nodes(const GltfAnimation& animation, tinygltf::Model& model,
                                      const std::filesystem::path& path);

} // namespace hipmap
