#include "render/shading/normal_map.h"

#include "render/shading/textured_material.h"

#include <cmath>
#include <optional>

namespace hipmap {

namespace {

/// Directions on the surface in which the picture runs to the right and upwards; of any length.
struct PictureAxes {
    glm::vec3 right, up;
};

/// From the tangents of the file; none where it has none.
std::optional<PictureAxes> authored_axes(const TriangleMesh& mesh, const SurfacePoint& point,
                                         const glm::vec2& barycentric)
{
    const std::vector<glm::vec4>& tangents = mesh.attributes.tangents;
    if (tangents.empty())
        return std::nullopt;
    const glm::vec4 tangent = interpolate(tangents, mesh.corners[point.face], barycentric);
    const glm::vec3 right(tangent);
    if (!(glm::dot(right, right) > 0))
        return std::nullopt;
    const glm::vec3 up = glm::cross(point.shading_normal, right);
    return PictureAxes{right, tangent.w < 0 ? -up : up};
}

/// From how the picture lies on the face; none if it lies on a line.
std::optional<PictureAxes> axes_on_face(const TriangleMesh& mesh, const TextureSlot& slot,
                                        FaceId face)
{
    const std::vector<glm::vec2>& uv = mesh.attributes.uv[slot.uv_set];
    if (uv.empty())
        return std::nullopt;
    const glm::uvec3 c = mesh.corners[face];
    const glm::mat2 turn(slot.uv_transform);
    const glm::vec2 s = turn * (uv[c.y] - uv[c.x]), t = turn * (uv[c.z] - uv[c.x]);
    const glm::vec3 a = mesh.positions[c.y] - mesh.positions[c.x];
    const glm::vec3 b = mesh.positions[c.z] - mesh.positions[c.x];
    const float area = s.x * t.y - s.y * t.x;
    if (!(area != 0) || !std::isfinite(area))
        return std::nullopt;
    const float sign = area > 0 ? 1.0f : -1.0f;
    return PictureAxes{sign * (a * t.y - b * s.y), sign * (a * t.x - b * s.x)};
}

/// The part of `direction` across `normal`, unit; none if it has none.
std::optional<glm::vec3> across(const glm::vec3& direction, const glm::vec3& normal)
{
    const glm::vec3 part = direction - normal * glm::dot(direction, normal);
    const float length = glm::length(part);
    if (!(length > 0) || !std::isfinite(length))
        return std::nullopt;
    return part / length;
}

} // namespace

glm::vec3 mapped_normal(const Scene& scene, const SurfacePoint& point, const glm::vec2& barycentric)
{
    const TriangleMesh& mesh = scene.mesh;
    const glm::vec3& normal = point.shading_normal;
    const Material& material = scene.materials[mesh.material_of_face[point.face]];
    const TextureSlot* slot = find_texture(material.textures, TextureUse::normal);
    if (slot == nullptr || mesh.attributes.uv[slot->uv_set].empty())
        return normal;
    std::optional<PictureAxes> axes = authored_axes(mesh, point, barycentric);
    if (!axes)
        axes = axes_on_face(mesh, *slot, point.face);
    const std::optional<glm::vec3> right =
        axes ? across(axes->right, normal) : std::optional<glm::vec3>();
    if (!right)
        return normal;
    glm::vec3 up = glm::cross(normal, *right);
    if (glm::dot(up, axes->up) < 0)
        up = -up;
    const glm::vec3 read =
        2.0f * glm::vec3(read_slot(scene, *slot, point.face, barycentric)) - 1.0f;
    const glm::vec3 tilted = slot->strength * (read.x * *right + read.y * up) + read.z * normal;
    const float length = glm::length(tilted);
    return length > 0 && glm::dot(tilted, point.geometric_normal) > 0 ? tilted / length : normal;
}

} // namespace hipmap
