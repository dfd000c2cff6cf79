#include "render/photons/seen_surfaces.h"

#include <algorithm>

namespace hipmap {

std::uint32_t SeenRegions::region_at(std::uint64_t side, const glm::vec3& position) const
{
    const auto found = std::ranges::lower_bound(sides, side);
    if (found == sides.end() || *found != side)
        return kNoRegion;
    std::uint32_t here = roots[static_cast<std::size_t>(found - sides.begin())];
    while (nodes[here].axis != kLeaf) {
        const Node& node = nodes[here];
        here = position[static_cast<int>(node.axis)] < node.split ? here + 1 : node.next;
    }
    const std::uint32_t region = nodes[here].next;
    const Bounds<glm::vec3>& box = regions[region].box;
    const bool within = glm::all(glm::lessThanEqual(box.low, position)) &&
                        glm::all(glm::lessThanEqual(position, box.high));
    return within ? region : kNoRegion;
}

} // namespace hipmap
