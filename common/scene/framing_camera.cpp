#include "common/scene/framing_camera.h"

#include "common/scene/copied_bounds.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hipmap {

namespace {

constexpr double kAngleOfView = 40.0 * std::numbers::pi / 180; ///< vertical
constexpr double kMargin = 1.05;

/// The share of the whole area that must face one way before the view leaves the front.  Closed
/// surfaces face every way alike, and their sum is zero.
constexpr double kOneSided = 0.05;

struct View {
    const char* name;
    glm::dvec3 towards_eye;
};

const View kViews[] = {{"the front (+Z)", {0.55, 0.4, 1.0}},
                       {"behind (-Z)", {-0.55, 0.4, -1.0}},
                       {"the right (+X)", {1.0, 0.4, -0.55}},
                       {"the left (-X)", {-1.0, 0.4, 0.55}}};

/// Sums over faces, square scene units.
struct FaceSum {
    glm::dvec3 facing{0.0};
    double area = 0;
};

FaceSum sum_of(const TriangleMesh& mesh, FaceId first, std::uint32_t count)
{
    FaceSum out;
    for (FaceId face = first; face < first + count; ++face) {
        const glm::dvec3 normal = scaled_normal(mesh, face);
        out.facing += normal;
        out.area += glm::length(normal);
    }
    return out;
}

const View& choose_view(const TriangleMesh& mesh)
{
    std::vector<FaceSum> of_shared;
    for (const SharedFaces& faces : mesh.shared)
        of_shared.push_back(sum_of(mesh, faces.first, faces.count));
    FaceSum all = sum_of(mesh, 0, static_cast<FaceId>(mesh.face_count()));
    for (const FaceCopy& copy : mesh.copies) {
        const double scale2 = copy.place.scale * copy.place.scale;
        const FaceSum& sum = of_shared[copy.shared];
        all.facing += scale2 * copy.place.direction(sum.facing);
        all.area += scale2 * sum.area;
    }
    all.facing.y = 0; // the view is from above in any case
    if (!(glm::length(all.facing) > kOneSided * all.area))
        return kViews[0];
    return *std::max_element(
        std::begin(kViews), std::end(kViews), [&](const View& a, const View& b) {
            return glm::dot(all.facing, a.towards_eye) < glm::dot(all.facing, b.towards_eye);
        });
}

} // namespace

Camera framing_camera(const TriangleMesh& mesh)
{
    const View& view = choose_view(mesh);
    const glm::dvec3 towards_eye = glm::normalize(view.towards_eye);
    const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), towards_eye));
    const glm::dvec3 up = glm::cross(towards_eye, right);
    const double tangent = std::tan(kAngleOfView / 2);
    const auto distance_for = [&](const glm::vec3& position) {
        const glm::dvec3 p(position);
        const double off_axis = std::max(std::abs(glm::dot(p, right)), std::abs(glm::dot(p, up)));
        return kMargin * off_axis / tangent + glm::dot(p, towards_eye);
    };
    double distance = 0.0;
    for (const glm::vec3& position : mesh.positions)
        distance = std::max(distance, distance_for(position));
    const auto boxes = boxes_of_shared<glm::vec3>(mesh.positions, mesh.shared);
    for (const FaceCopy& copy : mesh.copies) {
        // The distance is convex: no farther for any point than for some corner of a box.
        double most = 0;
        for (int i = 0; i < 8; ++i)
            most = std::max(
                most, distance_for(box_corner(box_around(copy.place, boxes[copy.shared]), i)));
        const SharedFaces& faces = mesh.shared[copy.shared];
        for (std::size_t v = 0; v < faces.vertex_count && most > distance; ++v)
            distance = std::max(distance, distance_for(glm::vec3(copy.place.point(glm::dvec3(
                                              mesh.positions[faces.first_vertex + v])))));
    }
    if (!(distance > 0))
        distance = 1.0; // every vertex in one point: any view is as good
    Camera camera;
    camera.name = view.name;
    camera.position = glm::vec3(towards_eye * distance);
    camera.right = glm::vec3(right);
    camera.up = glm::vec3(up);
    camera.forward = glm::vec3(-towards_eye);
    camera.tan_half_height = static_cast<float>(tangent);
    camera.aspect = 1.0f;
    return camera;
}

} // namespace hipmap
