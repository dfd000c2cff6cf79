#include "preprocess/partition/patches.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <numbers>

namespace hipmap {
namespace {

/// The area of a patch as a share of the map's.  Parts are halved down to at most sqrt(2) times
/// this, so that they have at least 1/sqrt(2) of it where faces are small.
constexpr double kPatchFraction = 1.0 / 64;

/// Fewer have hardly more photons together than each of them.
constexpr std::size_t kLeastFaces = 4;

/// A leaf of more than this of a patch's area is taken face by face.
constexpr double kClumpFraction = 1.0 / 256;

/// A part of fewer clumps is split by one thread.
constexpr std::size_t kTaskClumps = 4096;

double area_of(std::span<const Clump> clumps)
{
    double area = 0;
    for (const Clump& clump : clumps)
        area += clump.area;
    return area;
}

int longest_axis(std::span<const Clump> clumps)
{
    Bounds<glm::vec3> box;
    for (const Clump& clump : clumps)
        box.add(clump.middle);
    const glm::vec3 extent = box.extent();
    if (extent.x >= extent.y && extent.x >= extent.z)
        return 0;
    return extent.y >= extent.z ? 1 : 2;
}

/// Orders clumps so that those before the returned place, neither none nor all, have about half of
/// their area and none lies beyond one after it on the longest axis.
std::size_t halve(std::span<Clump> clumps, double area)
{
    const auto before = [axis = longest_axis(clumps)](const Clump& a, const Clump& b) {
        return a.middle[axis] != b.middle[axis] ? a.middle[axis] < b.middle[axis]
                                                : a.begin < b.begin;
    };
    // Where half of the area is reached lies from `begin` to `end`.
    std::size_t begin = 0, end = clumps.size();
    double missing = area / 2;
    while (end - begin > 1) {
        const std::size_t middle = begin + (end - begin) / 2;
        const auto first = clumps.begin();
        std::nth_element(first + begin, first + middle, first + end, before);
        const double front = area_of(clumps.subspan(begin, middle - begin));
        if (front < missing) {
            missing -= front;
            begin = middle;
        } else {
            end = middle;
        }
    }
    return std::clamp<std::size_t>(2 * missing < clumps[begin].area ? begin : end, 1,
                                   clumps.size() - 1);
}

/// Gives the faces of each patch the number of one of them.
/// faces: in the order of the tree.  largest: area of a patch, and of any clump at most.
void split(std::span<Clump> clumps, std::span<const FaceId> faces, double largest,
           std::span<std::uint32_t> patch_of_face)
{
    std::size_t count = 0;
    double area = 0;
    for (const Clump& clump : clumps) {
        count += clump.end - clump.begin;
        area += clump.area;
    }
    if (count < kLeastFaces)
        return;
    if (area > largest) {
        const std::size_t middle = halve(clumps, area);
        const auto front = [&] { split(clumps.first(middle), faces, largest, patch_of_face); };
        const auto back = [&] { split(clumps.subspan(middle), faces, largest, patch_of_face); };
        if (clumps.size() < kTaskClumps)
            front(), back();
        else
            tbb::parallel_invoke(front, back);
        return;
    }
    std::ranges::sort(clumps, {}, &Clump::begin);
    for (const Clump& clump : clumps)
        for (const FaceId face : faces.subspan(clump.begin, clump.end - clump.begin))
            patch_of_face[face] = faces[clumps[0].begin];
}

Clump clump_of(const MapTree& map, std::uint32_t begin, std::uint32_t end)
{
    Bounds<glm::vec3> box;
    Clump clump{{}, begin, end, 0.0};
    for (const FaceId face : map.tree.faces({0, begin, end})) {
        const Bounds<glm::vec3> of_face = face_box(map.mesh, face);
        box.add(of_face.low);
        box.add(of_face.high);
        clump.area += face_area(map.mesh, face);
    }
    clump.middle = box.centre();
    return clump;
}

std::vector<Clump> clumps_of_leaves(const MapTree& map)
{
    std::vector<Clump> leaves(map.tree.leaf_count());
    tbb::parallel_for(std::uint32_t{0}, map.tree.leaf_count(), [&](std::uint32_t i) {
        const FaceTree::Range leaf = map.tree.leaf(i);
        leaves[i] = clump_of(map, leaf.begin, leaf.end);
    });
    return leaves;
}

/// Leaves as far as they are small enough, else their faces; without those larger than a patch.
std::vector<Clump> fine_clumps(const MapTree& map, std::span<const Clump> leaves, double largest)
{
    std::vector<Clump> clumps;
    for (const Clump& leaf : leaves) {
        if (leaf.area <= kClumpFraction * largest) {
            clumps.push_back(leaf);
            continue;
        }
        for (std::uint32_t at = leaf.begin; at < leaf.end; ++at)
            if (const Clump alone = clump_of(map, at, at + 1); alone.area <= largest)
                clumps.push_back(alone);
    }
    return clumps;
}

} // namespace

std::uint32_t number_by_first(std::vector<std::uint32_t>& labels)
{
    std::vector<std::uint32_t> number(labels.size(), kNone);
    std::uint32_t next = 0;
    for (std::uint32_t& label : labels) {
        if (label == kNone)
            continue;
        if (number[label] == kNone)
            number[label] = next++;
        label = number[label];
    }
    return next;
}

Patches find_patches(const MapTree& map, std::span<std::uint32_t> patch_of_face)
{
    const std::span<const FaceId> faces = map.tree.faces(map.tree.root());
    Patches out;
    const std::vector<Clump> leaves = clumps_of_leaves(map);
    const double largest = std::numbers::sqrt2 * kPatchFraction * area_of(leaves);
    out.clumps = fine_clumps(map, leaves, largest);
    split(out.clumps, faces, largest, patch_of_face);
    const auto patch_of = [&](const Clump& clump) { return patch_of_face[faces[clump.begin]]; };
    std::erase_if(out.clumps, [&](const Clump& clump) { return patch_of(clump) == kNone; });
    for (std::uint32_t i = 0; i < out.clumps.size(); ++i)
        if (i == 0 || patch_of(out.clumps[i]) != patch_of(out.clumps[i - 1]))
            out.first.push_back(i);
    out.first.push_back(static_cast<std::uint32_t>(out.clumps.size()));
    return out;
}

} // namespace hipmap
