#include "render/shading/texture_axes.h"

#include "render/shading/textured_material.h"

#include <cmath>

namespace hipmap {

namespace {

/// From the tangents of the file; none where it has none.  Of any length.
std::optional<TextureAxes> authored_axes(const TriangleMesh& mesh, const SurfacePoint& point,
                                         const glm::vec2& barycentric)
{
    const std::vector<glm::vec4>& tangents = mesh.attributes.tangents;
    if (tangents.empty())
        return std::nullopt;
    const glm::vec4 tangent = interpolate(tangents, mesh.vertices_of(point.face), barycentric);
    glm::vec3 right(tangent);
    if (mesh.is_copied(point.face)) [[unlikely]]
        right = glm::vec3(mesh.copy_of(point.face).place.direction(glm::dvec3(right)));
    if (!(glm::dot(right, right) > 0))
        return std::nullopt;
    const glm::vec3 up = glm::cross(point.shading_normal, right);
    return TextureAxes{right, tangent.w < 0 ? -up : up};
}

/// From how the texture lies on the face; none if it lies on a line.  Of any length.
std::optional<TextureAxes> axes_on_face(const TriangleMesh& mesh, const TextureSlot& slot,
                                        FaceId face)
{
    const std::vector<glm::vec2>& uv = mesh.attributes.uv[slot.uv_set];
    if (uv.empty())
        return std::nullopt;
    const glm::uvec3 c = mesh.vertices_of(face);
    const auto corners = mesh.triangle(face);
    const glm::mat2 turn(slot.uv_transform);
    const glm::vec2 s = turn * (uv[c.y] - uv[c.x]), t = turn * (uv[c.z] - uv[c.x]);
    const glm::vec3 a = corners[1] - corners[0];
    const glm::vec3 b = corners[2] - corners[0];
    const float area = s.x * t.y - s.y * t.x;
    if (!(area != 0) || !std::isfinite(area))
        return std::nullopt;
    const float sign = area > 0 ? 1.0f : -1.0f;
    return TextureAxes{sign * (a * t.y - b * s.y), sign * (a * t.x - b * s.x)};
}

} // namespace

std::optional<TextureAxes> texture_axes(const TriangleMesh& mesh, const TextureSlot& slot,
                                        const SurfacePoint& point, const glm::vec2& barycentric)
{
    std::optional<TextureAxes> axes = authored_axes(mesh, point, barycentric);
    if (!axes)
        axes = axes_on_face(mesh, slot, point.face);
    const std::optional<glm::vec3> right =
        axes ? part_across(axes->right, point.shading_normal) : std::optional<glm::vec3>();
    if (!right)
        return std::nullopt;
    const glm::vec3 up = glm::cross(point.shading_normal, *right);
    return TextureAxes{*right, glm::dot(up, axes->up) < 0 ? -up : up};
}

std::optional<glm::vec3> part_across(const glm::vec3& direction, const glm::vec3& normal)
{
    const glm::vec3 part = direction - normal * glm::dot(direction, normal);
    const float length = glm::length(part);
    if (!(length > 0) || !std::isfinite(length))
        return std::nullopt;
    return part / length;
}

} // namespace hipmap
