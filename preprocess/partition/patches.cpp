#include "preprocess/partition/patches.h"

#include "preprocess/partition/face_tree.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace hipmap {
namespace {

/// Of the map's area.  Parts are halved down to at most sqrt(2) times it, so that they have at
/// least 1/sqrt(2) of it where faces are small.
constexpr double kPatchFraction = 1.0 / 64;

/// Fewer have hardly more photons together than each of them.
constexpr std::size_t kLeastFaces = 4;

/// A part of fewer faces is split by one thread.
constexpr std::size_t kTaskSize = 4096;

struct Item {
    glm::vec3 middle{0.0f}; ///< of its box, so that the two halves of a square stay together
    FaceId face = kNone;
    double area = 0.0;
};

double area_of(std::span<const Item> items)
{
    double area = 0;
    for (const Item& item : items)
        area += item.area;
    return area;
}

int longest_axis(std::span<const Item> items)
{
    Bounds<glm::vec3> box;
    for (const Item& item : items)
        box.add(item.middle);
    const glm::vec3 extent = box.extent();
    if (extent.x >= extent.y && extent.x >= extent.z)
        return 0;
    return extent.y >= extent.z ? 1 : 2;
}

/// Orders items so that those before the returned place, neither none nor all, have about half of
/// their area and none lies beyond one after it on the longest axis.
std::size_t halve(std::span<Item> items, double area)
{
    const auto before = [axis = longest_axis(items)](const Item& a, const Item& b) {
        return a.middle[axis] != b.middle[axis] ? a.middle[axis] < b.middle[axis] : a.face < b.face;
    };
    // Where half of the area is reached lies from `begin` to `end`.
    std::size_t begin = 0, end = items.size();
    double missing = area / 2;
    while (end - begin > 1) {
        const std::size_t middle = begin + (end - begin) / 2;
        const auto first = items.begin();
        std::nth_element(first + begin, first + middle, first + end, before);
        const double front = area_of(items.subspan(begin, middle - begin));
        if (front < missing) {
            missing -= front;
            begin = middle;
        } else {
            end = middle;
        }
    }
    return std::clamp<std::size_t>(2 * missing < items[begin].area ? begin : end, 1,
                                   items.size() - 1);
}

/// Gives the faces of each patch the number of one of them.
/// largest: area of a patch, and of any item at most.
void split(std::span<Item> items, double largest, std::vector<std::uint32_t>& patch_of_face)
{
    if (items.size() < kLeastFaces)
        return;
    const double area = area_of(items);
    if (area > largest) {
        const std::size_t middle = halve(items, area);
        const auto front = [&] { split(items.first(middle), largest, patch_of_face); };
        const auto back = [&] { split(items.subspan(middle), largest, patch_of_face); };
        if (items.size() < kTaskSize)
            front(), back();
        else
            tbb::parallel_invoke(front, back);
        return;
    }
    for (const Item& item : items)
        patch_of_face[item.face] = items[0].face;
}

} // namespace

SortedFaces sort_faces(std::span<const FaceId> faces, std::span<const std::uint32_t> label_of_face,
                       std::uint32_t labels)
{
    SortedFaces out;
    out.first.assign(labels + std::size_t{2}, 0);
    for (const FaceId face : faces)
        if (label_of_face[face] != kNone)
            ++out.first[label_of_face[face] + std::size_t{2}];
    std::partial_sum(out.first.begin(), out.first.end(), out.first.begin());
    out.faces.resize(out.first.back());
    for (const FaceId face : faces)
        if (label_of_face[face] != kNone)
            out.faces[out.first[label_of_face[face] + std::size_t{1}]++] = face;
    out.first.pop_back();
    return out;
}

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

Patches find_patches(const TriangleMesh& mesh, const SharedMaps& maps)
{
    std::vector<FaceId> all(mesh.face_count());
    std::iota(all.begin(), all.end(), 0u);
    const SortedFaces faces = sort_faces(all, maps.map_of_face, maps.count);
    Patches out;
    out.patch_of_face.assign(mesh.face_count(), kNone);
    tbb::parallel_for(MapId{0}, maps.count, [&](MapId map) {
        const std::span<const FaceId> here = faces.of(map);
        std::vector<Item> items(here.size());
        tbb::parallel_for(std::size_t{0}, here.size(), [&](std::size_t i) {
            items[i] = {face_box(mesh, here[i]).centre(), here[i], face_area(mesh, here[i])};
        });
        const double largest = std::numbers::sqrt2 * kPatchFraction * area_of(items);
        std::erase_if(items, [&](const Item& item) { return item.area > largest; });
        split(items, largest, out.patch_of_face);
    });
    out.count = number_by_first(out.patch_of_face);
    return out;
}

} // namespace hipmap
