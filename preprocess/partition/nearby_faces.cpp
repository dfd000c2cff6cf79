#include "preprocess/partition/nearby_faces.h"

#include "preprocess/partition/face_tree.h"

// foreach_target compiles what follows it once for each instruction set.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "preprocess/partition/nearby_faces.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace hipmap::HWY_NAMESPACE {

/// Sets bit c of each front where a corner is before plane c, dot(corner, xyz) > w.  A loop that
/// compilers vectorise; without fused multiply-add it says the same on every processor.
void FindFronts(const NearbyFaces::Places& places, const std::array<glm::vec4, 3>& planes,
                std::size_t count, std::uint32_t* front)
{
    for (std::size_t i = 0; i < count; ++i) {
        std::uint32_t bits = 0;
        for (std::uint32_t c = 0; c < 3; ++c) {
            std::uint32_t before = 0;
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const float height = places[3 * corner][i] * planes[c].x +
                                     places[3 * corner + 1][i] * planes[c].y +
                                     places[3 * corner + 2][i] * planes[c].z;
                before |= height > planes[c].w;
            }
            bits |= before << c;
        }
        front[i] = bits;
    }
}

} // namespace hipmap::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace hipmap {

HWY_EXPORT(FindFronts);

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
    std::array<glm::vec4, 3> in_float;
    for (std::size_t c = 0; c < 3; ++c) {
        const double level = glm::dot(planes[c].origin, planes[c].inward) + kSlack * error;
        in_float[c] = glm::vec4(glm::vec3(planes[c].inward), static_cast<float>(level));
    }
    HWY_DYNAMIC_DISPATCH(FindFronts)(places_, in_float, count_, front_.data());
}

} // namespace hipmap
#endif
