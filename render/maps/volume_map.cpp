#include "render/maps/volume_map.h"

#include "common/math/bounds.h"
#include "common/math/sampling.h"
#include "render/maps/wide_search.h"
#include "render/media/phase.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace hipmap {

namespace {

constexpr std::uint32_t kLeaf = 8;

/// No radius is smaller, over the widest: photons in one place have a density, too.
constexpr float kNarrowest = 0x1p-20f;

/// Returns the number of nodes of a subtree; it depends on the number of photons alone, so that
/// every node's place is known.
std::uint32_t nodes_of(std::uint32_t photons)
{
    if (photons <= kLeaf)
        return 1;
    const std::uint32_t left = photons / 2;
    return 1 + nodes_of(left) + nodes_of(photons - left);
}

struct Builder {
    const std::vector<VolumePhoton>& photons;
    const std::vector<float>& radii;
    std::vector<std::uint32_t>& order;
    std::vector<VolumeMap::Node>& nodes;

    /// What a disc may reach, with room for rounding.
    float reach(std::uint32_t photon) const
    {
        const glm::vec3 p = glm::abs(photons[photon].position);
        return radii[photon] * 1.001f + 0x1p-20f * std::max(p.x, std::max(p.y, p.z));
    }

    void add_box(VolumeMap::Node& node, std::uint32_t first, std::uint32_t count) const
    {
        Bounds<glm::vec3> box;
        for (std::uint32_t i = first; i < first + count; ++i) {
            const glm::vec3& p = photons[order[i]].position;
            box.add(p - reach(order[i]));
            box.add(p + reach(order[i]));
        }
        node.low = box.low;
        node.high = box.high;
    }

    int longest_axis(std::uint32_t first, std::uint32_t count) const
    {
        Bounds<glm::vec3> box;
        for (std::uint32_t i = first; i < first + count; ++i)
            box.add(photons[order[i]].position);
        return hipmap::longest_axis(box.extent());
    }

    void build(std::uint32_t at, std::uint32_t first, std::uint32_t count) const
    {
        VolumeMap::Node& node = nodes[at];
        if (count <= kLeaf) {
            node.first = first;
            node.count = count;
            add_box(node, first, count);
            return;
        }
        const int axis = longest_axis(first, count);
        const std::uint32_t half = count / 2;
        const auto begin = order.begin() + first;
        std::nth_element(begin, begin + half, begin + count, [&](std::uint32_t a, std::uint32_t b) {
            return std::pair(photons[a].position[axis], a) <
                   std::pair(photons[b].position[axis], b);
        });
        node.right = at + 1 + nodes_of(half);
        const auto left = [&] { build(at + 1, first, half); };
        const auto right = [&] { build(node.right, first + half, count - half); };
        if (count > 4096) {
            tbb::parallel_invoke(left, right);
        } else {
            left();
            right();
        }
        node.low = glm::min(nodes[at + 1].low, nodes[node.right].low);
        node.high = glm::max(nodes[at + 1].high, nodes[node.right].high);
    }
};

/// Whether the part of the ray touches the box; comparisons with NaN, of a ray in the plane of a
/// side, leave it to the other sides.
bool touches(const VolumeMap::Node& node, const Ray& ray, const glm::vec3& inverse)
{
    float near = ray.near, far = ray.far;
    for (int c = 0; c < 3; ++c) {
        float a = (node.low[c] - ray.origin[c]) * inverse[c];
        float b = (node.high[c] - ray.origin[c]) * inverse[c];
        if (a > b)
            std::swap(a, b);
        near = a > near ? a : near;
        far = b < far ? b : far;
    }
    return near <= far * (1 + 0x1p-20f);
}

/// Area of a disc about the photon, across the direction, as far as it lies on the photon's side of
/// the plane at `wall`, docs/media.md (8).
float disc_area(const glm::vec3& wall, const glm::vec3& direction, float radius)
{
    const float distance2 = glm::dot(wall, wall);
    const float along = glm::dot(wall, direction);
    const float across2 = distance2 - along * along;
    const float whole = kPi * radius * radius;
    if (!(distance2 > 0) || !(across2 > 0))
        return whole;
    const float height = distance2 / (std::sqrt(across2) * radius);
    if (!(height < 1))
        return whole;
    return whole - radius * radius * (std::acos(height) - height * std::sqrt(1 - height * height));
}

/// Adds a photon's part to the sums.
void add_photon(const VolumeMap& map, std::uint32_t i, const Beam& beam, const BeamScales& scales,
                std::array<Rgb, 3>& sums)
{
    const Ray& ray = beam.optical_depth.part;
    const VolumePhoton& photon = map.photons[i];
    const float radius = map.radii[i];
    const glm::vec3& wall = map.walls[i];
    const glm::vec3 way = photon.position - ray.origin;
    const float along = glm::dot(way, ray.direction);
    if (!(along >= ray.near && along < ray.far))
        return;
    const glm::vec3 aside = way - along * ray.direction;
    const float distance2 = glm::dot(aside, aside);
    if (!(distance2 < radius * radius) || -glm::dot(aside, wall) > glm::dot(wall, wall))
        return;
    const float phase = phase_value(beam.medium.phase, -glm::dot(photon.travel, ray.direction));
    const Rgb left =
        transmitted(beam.medium.extinction(), optical_depth_to(beam.optical_depth, along));
    const Rgb part = photon.power * left * phase;
    for (std::size_t s = 0; s < scales.size(); ++s) {
        const float narrower = radius * scales[s];
        if (distance2 < narrower * narrower)
            sums[s] += part / disc_area(wall, ray.direction, narrower);
    }
}

} // namespace

VolumeRadii find_volume_radii(const std::vector<VolumePhoton>& pilot, std::uint32_t neighbours,
                              float widest)
{
    std::vector<TreePoint> points;
    for (const VolumePhoton& photon : pilot)
        points.push_back({photon.position, static_cast<std::uint32_t>(points.size())});
    const WideTree all = build_wide_tree(points);
    std::vector<TreePoint> some = every_nth_photon(all, kPhotonsOfRadius);
    VolumeRadii out;
    out.widest = widest;
    out.tree = build_wide_tree(some);
    out.radius.resize(some.size());
    using Range = tbb::blocked_range<std::size_t>;
    tbb::parallel_for(Range(0, some.size(), 256), [&](const Range& range) {
        TreeScratch scratch;
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            const FoundSlots found = find_nearest(
                all, {some[i].position, neighbours, widest * widest, {}, nullptr}, scratch);
            const float radius =
                found.slots.size() == neighbours ? std::sqrt(found.farthest2) : widest;
            out.radius[i] = std::max(radius, kNarrowest * widest);
        }
    });
    return out;
}

float volume_radius_at(const VolumeRadii& radii, const glm::vec3& position)
{
    if (radii.radius.empty())
        return radii.widest;
    const NearPhoton near = near_photon(radii.tree, position);
    const float radius = radii.radius[near.slot];
    return std::min(radii.widest, std::sqrt(radius * radius + near.distance2));
}

VolumeMap build_volume_map(const std::vector<VolumePhoton>& photons, const VolumeRadii& first,
                           float shrink, const EmbreeScene& rays)
{
    VolumeMap out;
    const auto size = static_cast<std::uint32_t>(photons.size());
    if (size == 0)
        return out;
    std::vector<float> radii(size);
    std::vector<glm::vec3> walls(size, glm::vec3(0));
    tbb::parallel_for(std::uint32_t{0}, size, [&](std::uint32_t i) {
        radii[i] = shrink * volume_radius_at(first, photons[i].position);
        if (const auto face = rays.closest_point(photons[i].position, radii[i]))
            walls[i] = *face - photons[i].position;
    });
    std::vector<std::uint32_t> order(size);
    std::iota(order.begin(), order.end(), 0u);
    out.nodes.resize(nodes_of(size));
    Builder{photons, radii, order, out.nodes}.build(0, 0, size);
    for (const std::uint32_t i : order) {
        out.photons.push_back(photons[i]);
        out.radii.push_back(radii[i]);
        out.walls.push_back(walls[i]);
    }
    return out;
}

std::array<Rgb, 3> beam_radiance(const VolumeMap& map, const Beam& beam, const BeamScales& scales)
{
    std::array<Rgb, 3> sums{};
    if (map.nodes.empty() || !beam.medium.scatters())
        return sums;
    const Ray& ray = beam.optical_depth.part;
    const glm::vec3 inverse = 1.0f / ray.direction;
    std::array<std::uint32_t, 64> waiting; // the tree halves 2^32 photons at most
    std::size_t size = 0;
    waiting[size++] = 0;
    while (size > 0) {
        const std::uint32_t at = waiting[--size];
        const VolumeMap::Node& node = map.nodes[at];
        if (!touches(node, ray, inverse))
            continue;
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
            if (map.photons[i].inside == beam.inside)
                add_photon(map, i, beam, scales, sums);
        if (node.count == 0) {
            waiting[size++] = node.right;
            waiting[size++] = at + 1;
        }
    }
    return sums;
}

} // namespace hipmap
