#include "preprocess/prediction/tree_rays.h"

#include <algorithm>
#include <array>

namespace hipmap {

namespace {

/// A ray ready for the boxes of a tree.
struct BoxRay {
    glm::vec3 origin, inverse;

    /// Distance at which the ray enters a box; infinite: it misses the box within `far`.
    float enters(const Bounds<glm::vec3>& box, float far) const
    {
        const glm::vec3 a = (box.low - origin) * inverse, b = (box.high - origin) * inverse;
        const glm::vec3 first = glm::min(a, b), last = glm::max(a, b);
        const float enter = std::max(std::max(first.x, first.y), std::max(first.z, 0.0f));
        const float leave = std::min(std::min(last.x, last.y), std::min(last.z, far));
        // Widened by the rounding of three operations, so that no face of the box is lost.
        constexpr float kWider = 1 + 4 * std::numeric_limits<float>::epsilon();
        return enter <= leave * kWider ? enter : std::numeric_limits<float>::infinity();
    }
};

/// Moeller and Trumbore 1997.
void meet_face(const TriangleMesh& mesh, FaceId face, const Ray& ray, RayHit& best)
{
    const glm::uvec3& c = mesh.corners[face];
    const glm::vec3 a = mesh.positions[c.x];
    const glm::vec3 to_b = mesh.positions[c.y] - a, to_c = mesh.positions[c.z] - a;
    const glm::vec3 across = glm::cross(ray.direction, to_c);
    const float scale = glm::dot(to_b, across);
    if (scale == 0)
        return;
    const glm::vec3 from = ray.origin - a;
    const float u = glm::dot(from, across) / scale;
    if (!(u >= 0 && u <= 1))
        return;
    const glm::vec3 side = glm::cross(from, to_b);
    const float v = glm::dot(ray.direction, side) / scale;
    if (!(v >= 0 && u + v <= 1))
        return;
    const float distance = glm::dot(to_c, side) / scale;
    if (!(distance >= ray.near && distance <= best.distance) ||
        (distance == best.distance && face > best.face))
        return;
    best = {distance, face, {u, v}};
}

} // namespace

std::optional<RayHit> nearest_in_tree(const TriangleMesh& mesh, const FaceTree& tree,
                                      const Ray& ray)
{
    struct Entry {
        FaceTree::Range range;
        float enters;
    };
    const BoxRay boxes{ray.origin, 1.0f / ray.direction};
    RayHit best;
    best.distance = ray.far;
    std::array<Entry, FaceTree::kMostDepth + 2> stack;
    std::size_t depth = 0;
    const auto push = [&](const Entry& entry) {
        stack[depth] = entry;
        depth += entry.enters <= best.distance && std::isfinite(entry.enters) ? 1 : 0;
    };
    push({tree.root(), boxes.enters(tree.box(tree.root()), best.distance)});
    while (depth > 0) {
        const Entry entry = stack[--depth];
        if (entry.enters > best.distance)
            continue;
        if (tree.is_leaf(entry.range)) {
            for (const FaceId face : tree.faces(entry.range))
                meet_face(mesh, face, ray, best);
            continue;
        }
        const auto [left, right] = tree.children(entry.range);
        Entry near{left, boxes.enters(tree.box(left), best.distance)};
        Entry far{right, boxes.enters(tree.box(right), best.distance)};
        if (far.enters < near.enters)
            std::swap(near, far);
        push(far);
        push(near);
    }
    return best.face == kNone ? std::nullopt : std::optional(best);
}

} // namespace hipmap
