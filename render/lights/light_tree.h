#pragma once

#include "render/lights/light_bounds.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace hipmap {

/// A binary tree of lights, with one light in each leaf; a node comes before its children, and its
/// first child follows it directly.
struct LightTree {
    struct Node {
        LightBounds bounds;
        std::uint32_t parent = 0;
        std::uint32_t second = 0; ///< child; 0: a leaf
        std::uint32_t end = 0;    ///< after what is below the node
        std::uint32_t light = 0;  ///< of a leaf
    };
    std::vector<Node> nodes;
    std::vector<std::uint32_t> leaf_of; ///< [lights]

    bool empty() const { return nodes.empty(); }
};

/// Builds a light tree.  O(n log n).  No lights: an empty tree.  Source: Conty Estevez and Kulla
/// 2018, "Importance Sampling of Many Lights with Adaptive Tree Splitting", section 4.
LightTree build_light_tree(const std::vector<LightBounds>& lights);

struct ChosenLight {
    std::uint32_t light = 0;
    double probability = 0.0; ///< above zero
};

/// Chooses a light: descends the tree, at each node by the importance of its children to the
/// receiver.  u: [0, 1).  Nothing: no light can reach the receiver.  The tree must not be empty.
/// docs/light_transport.md (25).
std::optional<ChosenLight> choose_light(const LightTree& tree, const LightReceiver& at, double u);

/// Returns the probability with which `choose_light` chooses the light.  The probabilities of all
/// lights add up to one, or to zero if no light can reach the receiver.
double probability_of(const LightTree& tree, const LightReceiver& at, std::uint32_t light);

/// Calls visit(light) for every light whose box a ray may meet.  direction: unit.
template <typename Visit>
void over_lights_along(const LightTree& tree, const glm::vec3& origin, const glm::vec3& direction,
                       const Visit& visit)
{
    for (std::uint32_t here = 0; here < tree.nodes.size();) {
        const LightTree::Node& node = tree.nodes[here];
        const bool met = may_meet(node.bounds.box, origin, direction);
        if (met && node.second == 0)
            visit(node.light);
        here = met ? here + 1 : node.end;
    }
}

} // namespace hipmap
