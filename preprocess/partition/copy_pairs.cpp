#include "preprocess/partition/copy_pairs.h"

#include "common/scene/copied_bounds.h"

namespace hipmap {

namespace {

std::vector<FaceId> faces_with_map(std::span<const std::uint32_t> map_of_face, FaceId first,
                                   FaceId end)
{
    std::vector<FaceId> out;
    for (FaceId face = first; face < end; ++face)
        if (map_of_face[face] != kNone)
            out.push_back(face);
    return out;
}

} // namespace

CopyPairs::CopyPairs(const TriangleMesh& mesh, std::span<const std::uint32_t> map_of_face,
                     double within)
    : mesh_(mesh), within_(within)
{
    std::vector<FaceId> rest;
    FaceId next = 0;
    const auto add_rest = [&](FaceId end) {
        const std::vector<FaceId> some = faces_with_map(map_of_face, next, end);
        rest.insert(rest.end(), some.begin(), some.end());
    };
    for (const SharedFaces& faces : mesh.shared) {
        add_rest(faces.first);
        next = faces.first + faces.count;
        trees_.emplace_back(mesh, faces_with_map(map_of_face, faces.first, next));
    }
    add_rest(static_cast<FaceId>(mesh.face_count()));
    rest_ = FaceTree(mesh, rest);

    const auto boxes = boxes_of_shared<glm::vec3>(mesh.positions, mesh.shared);
    for (std::uint32_t i = 0; i < mesh.shared.size(); ++i)
        placed_.push_back({i, {}, 0, widened(boxes[i], within)});
    for (std::uint32_t i = 0; i < mesh.copies.size(); ++i) {
        const FaceCopy& copy = mesh.copies[i];
        placed_.push_back({copy.shared, copy.place,
                           mesh.finder.first_face(i) - mesh.shared[copy.shared].first,
                           widened(box_around(copy.place, boxes[copy.shared]), within)});
    }
    std::vector<FaceId> places;
    for (const Placed& placed : placed_) {
        const auto first = static_cast<std::uint32_t>(boxes_.positions.size());
        boxes_.positions.insert(boxes_.positions.end(), {placed.box.low, placed.box.high});
        boxes_.corners.emplace_back(first, first + 1, first + 1);
        places.push_back(static_cast<FaceId>(places.size()));
    }
    place_tree_ = FaceTree(boxes_, places);
}

void CopyPairs::add_faces(const FaceTree& tree, const Similarity& at, const Bounds<glm::vec3>& box,
                          std::uint32_t to_scene, std::vector<FaceId>& out) const
{
    const Bounds<glm::vec3> there =
        widened(box_around(inverse(at), box), within_ / at.scale); // rounding
    tree.visit(
        there, [](const FaceTree::Range&) { return false; },
        [&](FaceId face) {
            if (!meet(there, face_box(mesh_, face)))
                return;
            Bounds<glm::vec3> in_scene;
            for (const glm::vec3& corner : mesh_.triangle(face + to_scene))
                in_scene.add(corner);
            if (meet(box, in_scene))
                out.push_back(face + to_scene);
        });
}

Bounds<glm::vec3> CopyPairs::box_in(const Similarity& at, FaceId face) const
{
    Bounds<glm::vec3> out;
    for (const glm::vec3& corner : mesh_.triangle(face))
        out.add(glm::vec3(at.point_back(glm::dvec3(corner))));
    return widened(out, 2 * within_ / at.scale);
}

} // namespace hipmap
