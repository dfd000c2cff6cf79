#include "preprocess/partition/nearby_faces.h"

#include "preprocess/partition/face_tree.h"

namespace hipmap {

bool NearbyFaces::add(const TriangleMesh& mesh, FaceId face, const Bounds<glm::vec3>& box)
{
    if (count_ == kMost)
        return false;
    const glm::uvec3 corners = mesh.corners[face];
    const std::array<glm::vec3, 3> p{mesh.positions[corners.x], mesh.positions[corners.y],
                                     mesh.positions[corners.z]};
    faces_[count_] = face;
    for (std::size_t c = 0; c < 3; ++c)
        for (int axis = 0; axis < 3; ++axis)
            places_[3 * c + static_cast<std::size_t>(axis)][count_] = p[c][axis];
    count_ +=
        meet(box, {glm::min(glm::min(p[0], p[1]), p[2]), glm::max(glm::max(p[0], p[1]), p[2])});
    return true;
}

void NearbyFaces::sort_out(const std::array<EdgePlane, 3>& planes, double error)
{
    // Of coordinates up to C in size, dot(p, inward) is wrong by less than 4 sqrt(3) C 2^-24 in
    // float and `level` by sqrt(3) C 2^-24: together by 0.55 errors of 2^-20 C.
    constexpr double kSlack = 0.4;
    const std::size_t count = count_;
    std::array<glm::vec3, 3> n;
    std::array<float, 3> level;
    for (int c = 0; c < 3; ++c) {
        n[c] = glm::vec3(planes[c].inward);
        level[c] =
            static_cast<float>(glm::dot(planes[c].origin, planes[c].inward) + kSlack * error);
    }
    for (std::size_t i = 0; i < count; ++i) {
        std::uint32_t front = 0;
        for (std::uint32_t c = 0; c < 3; ++c) {
            std::uint32_t before = 0;
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const float height = places_[3 * corner][i] * n[c].x +
                                     places_[3 * corner + 1][i] * n[c].y +
                                     places_[3 * corner + 2][i] * n[c].z;
                before |= height > level[c];
            }
            front |= before << c;
        }
        front_[i] = front;
    }
}

} // namespace hipmap
