#pragma once

#include "common/math/bounds.h"
#include "common/scene/face_copies.h"

#include <array>
#include <span>
#include <vector>

namespace hipmap {

/// Returns a corner of a box, by bits 0 to 2 of a number.
template <typename Vec>
Vec box_corner(const Bounds<Vec>& box, int i)
{
    return {i & 1 ? box.high.x : box.low.x, i & 2 ? box.high.y : box.low.y,
            i & 4 ? box.high.z : box.low.z};
}

/// Returns the boxes of shared faces where they are stored.
template <typename Vec>
std::vector<Bounds<Vec>> boxes_of_shared(std::span<const Vec> positions,
                                         std::span<const SharedFaces> shared)
{
    std::vector<Bounds<Vec>> boxes(shared.size());
    for (std::size_t i = 0; i < shared.size(); ++i)
        for (const Vec& p : positions.subspan(shared[i].first_vertex, shared[i].vertex_count))
            boxes[i].add(p);
    return boxes;
}

/// Returns a box around a placed box.
template <typename Vec>
Bounds<Vec> box_around(const Similarity& place, const Bounds<Vec>& box)
{
    Bounds<Vec> out;
    for (int i = 0; i < 8; ++i)
        out.add(Vec(place.point(glm::dvec3(box_corner(box, i)))));
    return out;
}

/// Returns the box of all vertices and of those of copies, exactly.  Cost: linear in the vertices
/// that are stored, and in those of copies that reach out of the box of what comes before.
template <typename Vec>
Bounds<Vec> bounds_with_copies(std::span<const Vec> positions, std::span<const SharedFaces> shared,
                               std::span<const FaceCopy> copies)
{
    Bounds<Vec> all;
    for (const Vec& p : positions)
        all.add(p);
    const std::vector<Bounds<Vec>> boxes = boxes_of_shared(positions, shared);
    for (const FaceCopy& copy : copies) {
        const Bounds<Vec> around = box_around(copy.place, boxes[copy.shared]);
        if (glm::all(glm::lessThanEqual(all.low, around.low)) &&
            glm::all(glm::lessThanEqual(around.high, all.high)))
            continue;
        const SharedFaces& faces = shared[copy.shared];
        for (const Vec& p : positions.subspan(faces.first_vertex, faces.vertex_count))
            all.add(Vec(copy.place.point(glm::dvec3(p))));
    }
    return all;
}

} // namespace hipmap
