#include "common/rays/surface_point.h"

#include "common/rays/flat_point.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace hipmap {

namespace {

/// Bound of the relative rounding error of n float operations (Higham's gamma).
constexpr float rounding_bound(int n)
{
    const float half_ulp = std::numeric_limits<float>::epsilon() / 2;
    return n * half_ulp / (1 - n * half_ulp);
}

/// Shrinks a distance so that rounding cannot carry it past its end.
constexpr float kJustShort = 1 - 1e-4f;

/// Roundings of a matrix's inverse and of a point's transform in Embree.
constexpr int kPlacing = 12;

/// A face as it is stored, and the copy that it belongs to; null: it stands where it is stored.
struct StoredFace {
    const glm::uvec3& corners;
    const Similarity* place;
};

StoredFace stored(const TriangleMesh& mesh, FaceId face)
{
    if (mesh.is_copied(face)) [[unlikely]]
        return {mesh.vertices_of(face), &mesh.copy_of(face).place};
    return {mesh.corners[face], nullptr};
}

glm::vec3 interpolated_normal(const TriangleMesh& mesh, const StoredFace& face,
                              const glm::vec3& weights, const glm::vec3& geometric_normal)
{
    const glm::uvec3& c = face.corners;
    glm::vec3 sum = weights.x * mesh.normals[c.x] + weights.y * mesh.normals[c.y] +
                    weights.z * mesh.normals[c.z];
    if (face.place != nullptr) [[unlikely]]
        sum = glm::vec3(face.place->direction(glm::dvec3(sum)));
    const float length2 = glm::dot(sum, sum);
    if (!(length2 > 0) || !std::isfinite(length2))
        return geometric_normal;
    const glm::vec3 normal = sum / std::sqrt(length2);
    const float side = glm::dot(normal, geometric_normal);
    if (side == 0)
        return geometric_normal;
    return side > 0 ? normal : -normal;
}

/// Moves a point of a face to the same point of a copy.  Embree's hits may lie off the copy by what
/// its float matrices round, both ways, in any direction; so the bound is the same for each axis.
void place(const Similarity& copy, SurfacePoint& point)
{
    const glm::dvec3 stored(point.position);
    point.position = glm::vec3(copy.point(stored));
    const glm::dvec3 sizes = glm::abs(stored) * copy.scale + glm::abs(copy.move);
    const double largest = std::max(sizes.x, std::max(sizes.y, sizes.z));
    const double carried =
        std::max(point.position_error.x, std::max(point.position_error.y, point.position_error.z));
    point.position_error = glm::vec3(
        static_cast<float>(rounding_bound(kPlacing) * largest + 2 * copy.scale * carried));
}

glm::vec3 weights_of(const glm::vec2& barycentric)
{
    return {1 - barycentric.x - barycentric.y, barycentric.x, barycentric.y};
}

/// Without the shading normal, and before the point is moved to a copy.
SurfacePoint point_of(const TriangleMesh& mesh, const StoredFace& face, const glm::vec3& weights)
{
    const glm::vec3& first = mesh.positions[face.corners.x];
    const glm::vec3& second = mesh.positions[face.corners.y];
    const glm::vec3& third = mesh.positions[face.corners.z];
    const glm::vec3 a = weights.x * first, b = weights.y * second, d = weights.z * third;
    SurfacePoint point;
    point.position = a + b + d;
    point.position_error = rounding_bound(7) * (glm::abs(a) + glm::abs(b) + glm::abs(d));
    const glm::dvec3 from(first);
    glm::dvec3 normal = glm::cross(glm::dvec3(second) - from, glm::dvec3(third) - from);
    if (face.place != nullptr) [[unlikely]]
        normal = face.place->scale * face.place->scale * face.place->direction(normal);
    const double length = glm::length(normal);
    point.geometric_normal = length > 0 ? glm::vec3(normal / length) : glm::vec3(0, 0, 1);
    return point;
}

/// Returns the next float from `value` on in the direction of `towards`.
float next_towards(float value, float towards)
{
    if (value == 0 || !std::isfinite(value)) [[unlikely]]
        return std::nextafter(value, std::copysign(HUGE_VALF, towards));
    const auto bits = std::bit_cast<std::int32_t>(value);
    return std::bit_cast<float>((value < 0) == (towards < 0) ? bits + 1 : bits - 1);
}

} // namespace

SurfacePoint surface_point(const TriangleMesh& mesh, FaceId face, const glm::vec2& barycentric)
{
    const StoredFace in = stored(mesh, face);
    const glm::vec3 weights = weights_of(barycentric);
    SurfacePoint point = point_of(mesh, in, weights);
    point.face = face;
    point.shading_normal = interpolated_normal(mesh, in, weights, point.geometric_normal);
    if (in.place != nullptr) [[unlikely]]
        place(*in.place, point);
    return point;
}

SurfacePoint flat_point(const TriangleMesh& mesh, FaceId face, const glm::vec2& barycentric)
{
    const StoredFace in = stored(mesh, face);
    SurfacePoint point = point_of(mesh, in, weights_of(barycentric));
    point.face = face;
    point.shading_normal = point.geometric_normal;
    if (in.place != nullptr) [[unlikely]]
        place(*in.place, point);
    return point;
}

glm::vec3 offset_origin(const SurfacePoint& point, const glm::vec3& direction)
{
    const glm::vec3 n = point.geometric_normal;
    const float distance = glm::dot(glm::abs(n), point.position_error);
    const glm::vec3 offset = glm::dot(direction, n) < 0 ? -distance * n : distance * n;
    glm::vec3 origin = point.position + offset;
    // The addition may round back towards the face; go on to the next float.
    for (int i = 0; i < 3; ++i)
        if (offset[i] != 0)
            origin[i] = next_towards(origin[i], offset[i]);
    return origin;
}

Ray ray_between(const SurfacePoint& from, const glm::vec3& to)
{
    Ray ray;
    ray.origin = offset_origin(from, to - from.position);
    const glm::vec3 way = to - ray.origin;
    const float distance = glm::length(way);
    ray.direction = distance > 0 ? way / distance : from.geometric_normal;
    ray.far = distance * kJustShort;
    return ray;
}

Ray ray_between(const SurfacePoint& from, const SurfacePoint& to)
{
    return ray_between(from, offset_origin(to, from.position - to.position));
}

} // namespace hipmap
